# cmake --install of the portable presets: one folder that may be moved, and cpack's archive of it.
#   bin       the program; for Windows also the library
#   lib       the library with the C interface, for CMake, pkg-config and whatever opens libraries
#   include   its header, Fortran's module
#   data      standard profiles, scenes, bodies, influence files, pages: as in the sources, so that the pages' commands serve
include(CMakePackageConfigHelpers)

install(TARGETS bem_contact RUNTIME DESTINATION bin)
install(TARGETS conformal_contact EXPORT conformal_contact_shared
  RUNTIME DESTINATION bin LIBRARY DESTINATION lib ARCHIVE DESTINATION lib INCLUDES DESTINATION include)
install(FILES bem_contact/c/conformal_contact.h ${PROJECT_BINARY_DIR}/bem_contact/c/conformal_contact.f90 DESTINATION include)

set(cmake_dir lib/cmake/conformal_contact)
install(EXPORT conformal_contact_shared NAMESPACE conformal_contact:: FILE conformal_contact-config.cmake DESTINATION ${cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/conformal_contact-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/conformal_contact-config-version.cmake DESTINATION ${cmake_dir})
set(CMAKE_INSTALL_LIBDIR lib)
set(CMAKE_INSTALL_INCLUDEDIR include)
set(from_pc_to_prefix ../..)
configure_file(tools/cmake/conformal_contact.pc.in ${PROJECT_BINARY_DIR}/conformal_contact.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/conformal_contact.pc DESTINATION lib/pkgconfig)

install(DIRECTORY data/standards data/scenes data/bodies data/benchmark data/influence data/tutorial data/pictures DESTINATION data)
install(FILES data/TUTORIAL.md data/INFLUENCE_FORMAT.md DESTINATION data)
install(FILES tools/cmake/portable/README.md LICENSE LICENSES CITATION.cff CHANGELOG.md DESTINATION .)

if(WIN32)
  set(CPACK_GENERATOR ZIP)
else()
  set(CPACK_GENERATOR TGZ)
endif()
string(TOLOWER ${CMAKE_SYSTEM_NAME} system)
set(CPACK_PACKAGE_FILE_NAME conformal-contact-${PROJECT_VERSION}-${system}-x86_64)
set(CPACK_STRIP_FILES ON)
include(CPack)
