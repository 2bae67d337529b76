# cmake --install: programs, the shared library with its C header, the C++ headers that callers need, the static
# libraries, the Python package, small data, man pages and bash completion. Everything is found relative to the files
# themselves, so that the installed tree may be moved.
include(CMakePackageConfigHelpers)

set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/conformal_contact)

# The headers of a C++ caller: what Sequence takes and returns, what the rooms above it answer, and all that these include.
set(answers uses/conicity/wheelset_conicity uses/curves/creep_curves uses/fit/fit_curve uses/table/creep_table uses/table/scene_table
            uses/table/table_file uses/wear/wear_of_result uses/wear/evolution uses/fatigue/fatigue_of_result uses/shakedown/shakedown_of_result
            uses/wheelset/solve_wheelset
            uses/wheelset/quantities uses/sweep/sweep_case uses/sweep/sweep_columns)
set(public_headers)
set(todo sequence/sequence sequence/shared_files sequence/quantities scene/scene_file scene/scene_reader base/error base/provenance contact/work
         ${answers})
list(TRANSFORM todo REPLACE "(.+)" "bem_contact/\\1.hpp")
while(todo)
  list(POP_FRONT todo header)
  if(NOT header IN_LIST public_headers)
    list(APPEND public_headers ${header})
    file(STRINGS ${PROJECT_SOURCE_DIR}/${header} includes REGEX "^#include \"bem_contact/")
    list(TRANSFORM includes REPLACE "^#include \"([^\"]+)\".*" "\\1")
    list(APPEND todo ${includes})
  endif()
endwhile()
foreach(header ${public_headers})
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/${folder})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/bem_contact/c/conformal_contact.h
  ${PROJECT_BINARY_DIR}/bem_contact/c/conformal_contact.f90 DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# Those that a caller writes in a program, for Doxygen: doxygen build/Doxyfile makes build/reference/html.
set(doxygen_input bem_contact/c/conformal_contact.h)
foreach(header sequence/sequence sequence/shared_files sequence/quantities sequence/scene_result sequence/comparison sequence/scene_description
               sequence/stresses sequence/structural_result scene/scene_file scene/scene_text scene/scene_reader scene/choices
               contact/problem contact/result contact/work geometry/rigid_slip geometry/placement profile/contact_row
               halfspace/stress base/conventions base/error base/material base/provenance ${answers})
  list(APPEND doxygen_input bem_contact/${header}.hpp)
endforeach()
set(unknown ${doxygen_input})
list(REMOVE_ITEM unknown ${public_headers} bem_contact/c/conformal_contact.h)
if(unknown)
  message(FATAL_ERROR "Headers are documented that are not public: ${unknown}")
endif()
list(TRANSFORM doxygen_input REPLACE "(.+)" "\"${PROJECT_SOURCE_DIR}/\\1\"")
list(JOIN doxygen_input " " doxygen_input)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)

# The shared library needs nothing else of a caller. The static ones need the libraries that they were built with.
install(TARGETS conformal_contact EXPORT conformal_contact_shared
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS bem_contact_http LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP) # loaded by the program alone
install(TARGETS conformal_options ${conformal_library_rooms}
  EXPORT conformal_contact_static
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
foreach(kind shared static)
  install(EXPORT conformal_contact_${kind} NAMESPACE conformal_contact:: FILE conformal_contact-${kind}.cmake
    DESTINATION ${cmake_dir})
endforeach()
list(TRANSFORM conformal_library_rooms PREPEND conformal_contact:: OUTPUT_VARIABLE conformal_static_rooms)
list(JOIN conformal_static_rooms " " conformal_static_rooms)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/conformal_contact-config.cmake.in
  ${PROJECT_BINARY_DIR}/conformal_contact-config.cmake INSTALL_DESTINATION ${cmake_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/conformal_contact-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/conformal_contact-config.cmake
              ${PROJECT_BINARY_DIR}/conformal_contact-config-version.cmake DESTINATION ${cmake_dir})

file(RELATIVE_PATH from_pc_to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/conformal_contact.pc.in ${PROJECT_BINARY_DIR}/conformal_contact.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/conformal_contact.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

set(programs bem_contact)
if(CONFORMAL_WITH_FEM)
  list(APPEND programs mesh_body fem_influence)
endif()
install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

if(TARGET bem_contact_python)
  file(RELATIVE_PATH from_python_to_lib /prefix/${CONFORMAL_PYTHON_DIR}/bem_contact /prefix/${CMAKE_INSTALL_LIBDIR})
  set_target_properties(bem_contact_python PROPERTIES INSTALL_RPATH "$ORIGIN/lib;$ORIGIN/${from_python_to_lib}")
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/bem_contact/python/bem_contact DESTINATION ${CONFORMAL_PYTHON_DIR}
    PATTERN __pycache__ EXCLUDE)
  install(TARGETS bem_contact_python LIBRARY DESTINATION ${CONFORMAL_PYTHON_DIR}/bem_contact)
  install(FILES ${CMAKE_BINARY_DIR}/python/bem_contact/_numbers.pyi DESTINATION ${CONFORMAL_PYTHON_DIR}/bem_contact)
  install(FILES ${PROJECT_SOURCE_DIR}/bem_contact/record/words.json DESTINATION ${CONFORMAL_PYTHON_DIR}/bem_contact/plotting)
endif()

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/conformal-contact RENAME copyright)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSES DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/conformal-contact)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/conformal_contact
  PATTERN __pycache__ EXCLUDE)
# Pictures: the program and the Python package of the same tree draw them.
install(PROGRAMS ${PROJECT_SOURCE_DIR}/tools/plot ${PROJECT_SOURCE_DIR}/tools/paraview ${PROJECT_SOURCE_DIR}/tools/influence
  DESTINATION ${CMAKE_INSTALL_DATADIR}/conformal_contact/tools)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/cluster DESTINATION ${CMAKE_INSTALL_DATADIR}/conformal_contact/tools USE_SOURCE_PERMISSIONS
  PATTERN __pycache__ EXCLUDE PATTERN slurm_sweep EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/data/standards ${PROJECT_SOURCE_DIR}/data/scenes ${PROJECT_SOURCE_DIR}/data/bodies ${PROJECT_SOURCE_DIR}/data/influence
  DESTINATION ${CMAKE_INSTALL_DATADIR}/conformal_contact)

# Man pages and completion, from the programs' own help.
set(pages ${PROJECT_BINARY_DIR}/pages)
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE program_files)
add_custom_command(OUTPUT ${pages}/made
  COMMAND ${SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tools/makers/man_pages -o ${pages} ${program_files}
  COMMAND ${CMAKE_COMMAND} -E touch ${pages}/made
  DEPENDS ${programs} ${PROJECT_SOURCE_DIR}/tools/makers/man_pages
  COMMENT "Man pages and bash completion from the programs' help")
add_custom_target(man_pages ALL DEPENDS ${pages}/made)
install(DIRECTORY ${pages}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR})
install(DIRECTORY ${pages}/completions/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
