# cpack -G DEB: one Debian package with all that cmake --install installs. tools/checks/try_debian_package tries it.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME conformal-contact)
set(CPACK_PACKAGE_VENDOR "The conformal-contact developers")
set(CPACK_PACKAGE_CONTACT "The conformal-contact developers <conformal-contact@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "conformal wheel-rail contact by the boundary element method")
set(CPACK_PACKAGE_DESCRIPTION
  "Solves conformal rolling contact of wheel and rail.
The program bem_contact, a shared library with a C interface and C++ classes, their development files, the Python package
 bem_contact, example scenes and bodies, man pages and bash completion.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# What programs and libraries link is found by dpkg-shlibdeps: also what is opened later, since a library of ours needs it
# (conformal_opened_library()).
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
# The compiled part of the Python package is for one minor version.
execute_process(COMMAND ${SYSTEM_PYTHON} -c "import sys; print(*sys.version_info[:2])"
  OUTPUT_VARIABLE python_version OUTPUT_STRIP_TRAILING_WHITESPACE)
string(REPLACE " " ";" python_version ${python_version})
list(GET python_version 0 python_major)
list(GET python_version 1 python_minor)
math(EXPR python_next "${python_minor} + 1")
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "python3 (>= ${python_major}.${python_minor}), python3 (<< ${python_major}.${python_next}), python3-numpy")
# bem_contact plot and tools/paraview.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-h5py, python3-matplotlib")
# With the component `static` of find_package the libraries that ours are built with are linked again.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS
  "cmake, pkg-config, libeigen3-dev, libfmt-dev, libspdlog-dev, libboost-dev, libfftw3-dev, zlib1g-dev")
# Python compiles modules where they are imported; what it wrote goes with the package.
set(scripts ${PROJECT_BINARY_DIR}/debian)
file(WRITE ${scripts}/postinst "#!/bin/sh\nset -e\nif [ \"$1\" = configure ]; then py3compile -p conformal-contact; fi\n")
file(WRITE ${scripts}/prerm "#!/bin/sh\nset -e\npy3clean -p conformal-contact\n")
file(CHMOD ${scripts}/postinst ${scripts}/prerm
  PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${scripts}/postinst ${scripts}/prerm)
include(CPack)
