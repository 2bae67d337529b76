# Packages of Debian 12 and 13; tools/install_packages names them all.
find_package(PkgConfig REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(Boost 1.74 REQUIRED) # Boost.Math, headers alone: roots, quadrature points, elliptic integrals
if(CONFORMAL_FFT STREQUAL "fftw")
  pkg_check_modules(FFTW3 REQUIRED IMPORTED_TARGET fftw3 fftw3f)
elseif(NOT CONFORMAL_FFT STREQUAL "own")
  message(FATAL_ERROR "CONFORMAL_FFT is '${CONFORMAL_FFT}' (there are two kinds of transforms) say fftw or own")
endif()
pkg_check_modules(OPENBLAS REQUIRED IMPORTED_TARGET openblas)

# The page of `bem_contact explore`; only bem_contact/explore sees it.
pkg_check_modules(CPP_HTTPLIB REQUIRED IMPORTED_TARGET cpp-httplib)

# Only bem_contact/h5 sees HDF5. It is the serial library in every build: deal.II brings the
# OpenMPI one, and Debian gives the two different symbol versions, so that both may live in one
# process, because nothing is linked with both.
pkg_check_modules(HDF5_SERIAL REQUIRED IMPORTED_TARGET hdf5-serial)
pkg_check_modules(ZLIB REQUIRED IMPORTED_TARGET zlib)

find_file(TOMLPLUSPLUS_HEADER toml++/toml.h)
if(NOT TOMLPLUSPLUS_HEADER)
  message(FATAL_ERROR "toml++ was not found (the case files are TOML); run tools/install_packages")
endif()

find_file(XXHASH_HEADER xxhash.h)
if(NOT XXHASH_HEADER)
  message(FATAL_ERROR "xxHash was not found (checksums of influence files) run tools/install_packages")
endif()

# Debian's Python, with its h5py and NumPy, whatever other is first on the path.
find_program(SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
set(PYTHON_EXECUTABLE ${SYSTEM_PYTHON})
find_package(pybind11 REQUIRED)

# The pages of `bem_contact report`. Without it all else is built, and this command says what is missing.
find_file(PLOTLY_LIBRARY NAMES plotly.min.js plotly.js PATHS /usr/share/python3-plotly NO_DEFAULT_PATH)
if(NOT PLOTLY_LIBRARY)
  message(WARNING "plotly.js was not found (`bem_contact report` draws with it) run tools/install_packages")
endif()
find_program(ESBUILD esbuild)
if(NOT ESBUILD)
  message(WARNING "esbuild was not found (it makes one script of the modules of a page) run tools/install_packages")
endif()

if(CONFORMAL_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
endif()

if(CONFORMAL_WITH_FEM)
  find_package(MPI REQUIRED COMPONENTS CXX)
  find_package(deal.II 9.4 REQUIRED)
  find_library(GMSH_LIBRARY gmsh REQUIRED)
  find_path(GMSH_INCLUDE_DIR gmsh.h REQUIRED)
  find_library(DMUMPS_LIBRARY dmumps REQUIRED)
  find_path(MUMPS_INCLUDE_DIR dmumps_c.h REQUIRED)
  find_library(METIS_LIBRARY metis)
  find_path(METIS_INCLUDE_DIR metis.h)
  if(NOT METIS_LIBRARY OR NOT METIS_INCLUDE_DIR)
    message(FATAL_ERROR "METIS was not found (it orders the unknowns; Debian's MUMPS has none of its own) "
      "install libmetis-dev, or run tools/install_packages")
  endif()
endif()
