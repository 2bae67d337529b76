# What the solver in a page is built on (the preset browser, WebAssembly): those of Debian's headers that serve any machine. In
# place of libraries there are sha256_alone.cpp (OpenSSL), parallel_alone.cpp (OpenMP), dense_eigen.cpp (OpenBLAS),
# flat_files.cpp (HDF5) and bem_contact/contact/fft (FFTW).
if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.69)
  message(FATAL_ERROR "emscripten ${EMSCRIPTEN_VERSION} is too old (its standard library lacks parts of C++20) use Debian 13")
endif()
find_program(SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
find_program(NODE NAMES node nodejs REQUIRED)
find_file(PLOTLY_LIBRARY NAMES plotly.min.js plotly.js PATHS /usr/share/python3-plotly NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
find_program(ESBUILD esbuild NO_CMAKE_FIND_ROOT_PATH REQUIRED)

include(tools/cmake/headers.cmake)
conformal_host_headers(boost fmt nlohmann spdlog toml++ xxhash.h)
# A long double has 128 bits there: clang 19 fails on its constants, and Boost would compute with it.
add_library(conformal_boost INTERFACE)
target_compile_definitions(conformal_boost INTERFACE BOOST_MATH_NO_LONG_DOUBLE_MATH_FUNCTIONS)
add_library(Boost::headers ALIAS conformal_boost)

add_compile_options(-msimd128 $<$<COMPILE_LANGUAGE:CXX>:-fwasm-exceptions>)
add_link_options(-fwasm-exceptions)
set(CONFORMAL_FFT own)
