# What the portable program is built on (preset portable): it needs nothing but glibc, and nothing of it is under the GPL but our own
# sources. In place of libraries there are sha256_alone.cpp (OpenSSL), parallel_threads.cpp (OpenMP), dense_eigen.cpp (OpenBLAS) and
# bem_contact/contact/fft (FFTW). HDF5 and zlib are linked statically.
set(parts ${CONFORMAL_PARTS}/linux)
if(NOT EXISTS ${parts}/lib/hdf5.done)
  message(FATAL_ERROR "${parts} is not complete (this preset links what lies there) run tools/makers/portable_parts")
endif()
set(CONFORMAL_FFT own)
include(tools/cmake/headers.cmake)
conformal_host_headers(boost fmt nlohmann spdlog toml++ CLI xxhash.h)
add_library(Boost::headers ALIAS conformal_headers)

find_package(Threads REQUIRED)
add_library(conformal_zlib INTERFACE)
target_include_directories(conformal_zlib SYSTEM INTERFACE ${parts}/include)
target_link_libraries(conformal_zlib INTERFACE ${parts}/lib/libz.a)
add_library(PkgConfig::ZLIB ALIAS conformal_zlib)
add_library(conformal_hdf5 INTERFACE)
target_link_libraries(conformal_hdf5 INTERFACE -Wl,--start-group,${parts}/lib/libhdf5.a,${parts}/lib/libz.a,--end-group ${CMAKE_DL_LIBS} m Threads::Threads)
# The header alone holds the whole of cpp-httplib: as Debian has it in its source.
add_library(conformal_httplib INTERFACE)
target_include_directories(conformal_httplib SYSTEM INTERFACE ${parts}/include)
add_library(PkgConfig::CPP_HTTPLIB ALIAS conformal_httplib)

# Linked into all: what the compiler's libstdc++ takes of a newer glibc. It comes last, so that these are asked for before.
add_library(conformal_newer_glibc STATIC tools/cmake/portable/newer_glibc.c)
set_target_properties(conformal_newer_glibc PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
add_compile_options(-ffunction-sections -fdata-sections)
add_link_options(-Wl,--gc-sections -Wl,--no-undefined -Wl,--undefined=__libc_single_threaded -Wl,--undefined=arc4random)

find_program(SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_file(PLOTLY_LIBRARY NAMES plotly.min.js plotly.js PATHS /usr/share/python3-plotly NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
