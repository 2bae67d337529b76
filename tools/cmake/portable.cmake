# What the portable programs are built on (presets portable and portable-windows): they need nothing but the system, and nothing of
# them is under the GPL but our own sources. In place of libraries there are sha256_alone.cpp (OpenSSL), parallel_threads.cpp (OpenMP), dense_eigen.cpp (OpenBLAS) and
# bem_contact/contact/fft (FFTW). HDF5 and zlib are linked statically.
string(TOLOWER ${CMAKE_SYSTEM_NAME} system)
set(parts ${CONFORMAL_PARTS}/${system})
if(NOT EXISTS ${parts}/lib/hdf5.done)
  message(FATAL_ERROR "${parts} is not complete (this preset links what lies there) run tools/makers/portable_parts ${system}")
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

add_compile_options(-ffunction-sections -fdata-sections)
add_link_options(-Wl,--gc-sections -Wl,--no-undefined)
if(WIN32)
  add_link_options(-Wl,--stack,8388608) # bytes, as on Linux
  add_link_options(-Wl,--wrap=mbrtowc -Wl,--undefined=__wrap_mbrtowc) # base/system/windows/mbrtowc.c
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/portable/plain_words.hpp>")
else()
  # Linked into all: what the compiler's libstdc++ takes of a newer glibc. It comes last, so that these are asked for before.
  add_library(conformal_newer_glibc STATIC tools/cmake/portable/newer_glibc.c)
  set_target_properties(conformal_newer_glibc PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
  add_link_options(-Wl,--undefined=__libc_single_threaded -Wl,--undefined=arc4random)
endif()

find_program(SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_file(PLOTLY_LIBRARY NAMES plotly.min.js plotly.js PATHS /usr/share/python3-plotly NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_program(ESBUILD esbuild NO_CMAKE_FIND_ROOT_PATH REQUIRED)
