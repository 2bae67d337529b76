# One CMake target a room. Every room is compiled with the project's root as its only include
# directory, so an include line names its room: #include "bem_contact/base/error.hpp".

# What is installed for C++ callers, from the bottom to the top.
set(conformal_library_rooms base h5 record profile influence halfspace inside reference contact geometry scene sequence uses_conicity uses_curves
    uses_fit uses_table uses_wear uses_fatigue uses_shakedown uses_wheelset uses_sweep c)
list(TRANSFORM conformal_library_rooms PREPEND bem_contact_)

# Of every shared library: what callers rely on may change with the minor version.
set(CONFORMAL_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

add_library(conformal_options INTERFACE)
target_include_directories(conformal_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
if(TARGET conformal_headers)
  target_link_libraries(conformal_options INTERFACE conformal_headers)
endif()
target_compile_options(conformal_options INTERFACE $<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow>)
if(CONFORMAL_TUNABLE)
  target_compile_definitions(conformal_options INTERFACE CONFORMAL_TUNABLE)
endif()
if(CONFORMAL_SANITIZE)
  target_compile_options(conformal_options INTERFACE -fsanitize=${CONFORMAL_SANITIZERS}
                         -fno-sanitize-recover=all -fno-omit-frame-pointer
                         -Wno-maybe-uninitialized) # the compiler warns of its own checks of std::optional
  if(CONFORMAL_SANITIZERS MATCHES "address")
    # What the address sanitizer finds as well (null, object-size), or x86 and a code without casts do not need
    # (alignment, vptr): half of the time to compile.
    target_compile_options(conformal_options INTERFACE -fno-sanitize=null,object-size,alignment,vptr,pointer-overflow)
  endif()
  # no-pie: 550,000 addresses of checked variables stand at link time; each start takes two thirds of the time.
  # disable-new-dtags: the sanitizer opens libraries in our place, and only an old RPATH of the program holds there, too.
  target_link_options(conformal_options INTERFACE -fsanitize=${CONFORMAL_SANITIZERS} -Wl,--disable-new-dtags
                      $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:-no-pie>)
endif()

# conformal_room(<target> [SHARED] [SOURCES ...] [ROOMS ...] [LIBRARIES ...])
#   SOURCES    without it: every source below the room's folder
#   ROOMS      rooms whose headers this room's headers include (the arrows of the design)
#   LIBRARIES  third-party targets, private to the room
function(conformal_room target)
  cmake_parse_arguments(ARG "SHARED" "" "SOURCES;ROOMS;LIBRARIES" ${ARGN})
  if(NOT ARG_SOURCES)
    file(GLOB_RECURSE ARG_SOURCES CONFIGURE_DEPENDS *.cpp)
  endif()
  if(ARG_SHARED)
    add_library(${target} SHARED ${ARG_SOURCES})
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${CONFORMAL_SOVERSION})
  else()
    add_library(${target} STATIC ${ARG_SOURCES})
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${target} PUBLIC conformal_options ${ARG_ROOMS} PRIVATE ${ARG_LIBRARIES})
endfunction()

# conformal_opened_library(<room> <NAME> <library>): the room opens <library> with the first call of one of its functions
# (base/loaded_library.hpp). What it opens is a library of ours, CONFORMAL_<NAME>_LIBRARY, which holds nothing and needs
# <library>: so it is found where ours are, packages depend on <library>, and no source knows its version.
function(conformal_opened_library room name library)
  string(TOLOWER bem_contact_${name} target)
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/empty.c "")
  add_library(${target} SHARED ${CMAKE_CURRENT_BINARY_DIR}/empty.c)
  set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${CONFORMAL_SOVERSION})
  target_link_options(${target} PRIVATE -Wl,--no-as-needed)
  target_link_libraries(${target} PRIVATE ${library})
  target_compile_definitions(${room} PRIVATE CONFORMAL_${name}_LIBRARY="$<TARGET_SONAME_FILE_NAME:${target}>")
  add_dependencies(${room} ${target})
  install(TARGETS ${target} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP)
endfunction()

# conformal_bundle(<module.js> OPTION...): the module, with all that it imports, is one script of this name in the folder of
# the build; empty without esbuild. Its names stay those of the sources, so that tests and browsers can ask for them.
function(conformal_bundle module)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${module})
  if(NOT ESBUILD)
    file(WRITE ${script} "")
    return()
  endif()
  file(GLOB modules CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/bem_contact/report/*.js ${PROJECT_SOURCE_DIR}/bem_contact/explore/*.js)
  add_custom_command(OUTPUT ${script}
    COMMAND ${ESBUILD} ${module} --bundle --format=esm --charset=utf8 --target=es2022 --log-level=warning --outfile=${script} ${ARGN}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    DEPENDS ${modules} ${PROJECT_SOURCE_DIR}/bem_contact/record/words.json COMMENT "")
endfunction()

# conformal_embed(<variable> <prefix> FILE...): files become part of a room. <variable> is a source for it: FILE's bytes,
# with a NUL behind them, are the array <prefix>_<FILE as an identifier>.
function(conformal_embed variable prefix)
  foreach(file ${ARGN})
    cmake_path(ABSOLUTE_PATH file)
    cmake_path(GET file FILENAME name)
    string(MAKE_C_IDENTIFIER ${name} symbol)
    string(APPEND EMBEDDED "EMBED ${prefix}_${symbol}, \"${file}\"\n")
    list(APPEND files ${file})
  endforeach()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded.S)
  if(EMSCRIPTEN)
    set(template embedded_wasm.S.in)
  elseif(WIN32)
    set(template embedded_pe.S.in)
  else()
    set(template embedded.S.in)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/${template} ${source} @ONLY)
  set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${files}")
  set(${variable} ${source} PARENT_SCOPE)
endfunction()

# For targets that read, print and hand on: CLI11, TOML and JSON take long to optimise, and nobody waits for what they do.
function(conformal_hardly_optimised target)
  target_compile_options(${target} PRIVATE $<IF:$<BOOL:${CONFORMAL_SANITIZE}>,-O0,$<$<CONFIG:Release>:-O1>>)
endfunction()

# What every test includes, compiled once and used by all test programs.
if(CONFORMAL_TESTS)
  file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
  # Linked after the rooms, so that its options come last: it is the rooms that are checked, not their tests.
  add_library(conformal_test_options INTERFACE)
  if(CONFORMAL_SANITIZE)
    target_compile_definitions(conformal_test_options INTERFACE CONFORMAL_SANITIZED)
    if(CONFORMAL_SANITIZERS MATCHES "address") # Eigen allocates in another way under this one, and what rooms allocate tests free
      target_compile_definitions(conformal_test_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=0)
      target_compile_options(conformal_test_options INTERFACE -fno-sanitize=all -g0)
    endif()
  endif()
  if(CMAKE_UNITY_BUILD)
    # Several sources at once take a third of the time. Helpers of one room's tests need different names, and a local
    # name may hide one of another file. The preset separate compiles each source by itself, with that warning.
    target_compile_options(conformal_test_options INTERFACE -Wno-shadow)
  endif()
  add_library(conformal_test_headers OBJECT ${CMAKE_BINARY_DIR}/test_headers.cpp)
  target_link_libraries(conformal_test_headers PUBLIC conformal_options conformal_test_options fmt::fmt GTest::gmock)
  target_compile_options(conformal_test_headers PRIVATE -O0)
  target_precompile_headers(conformal_test_headers PRIVATE
    <algorithm> <cmath> <filesystem> <fstream> <string> <vector> <fmt/format.h> <gmock/gmock.h>)
endif()

# conformal_test(<name> [SOURCES ...] [SOLVERS ...] ROOMS ... [LIBRARIES ...]): one GoogleTest program a room. It is one test
# for ctest: a process for each of its tests took twice the time.
#   SOURCES    without it: every source of the folder
#   SOLVERS    sources that compute much themselves. The others are not optimised: they call the rooms,
#              and compile in half the time.
# The preset sanitize runs all tests of these programs (no tests/sanitized.hpp), so that they need no second run
# (CONFORMAL_TESTS_ONCE).
set(conformal_tests_under_sanitizers test_base test_base_alone test_record test_profile test_influence test_dense_eigen test_scene
    test_c test_explore test_fft_alone test_reference test_table)

function(conformal_test name)
  if(CONFORMAL_TESTS_ONCE AND name IN_LIST conformal_tests_under_sanitizers)
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "SOURCES;SOLVERS;ROOMS;LIBRARIES" ${ARGN})
  if(NOT ARG_SOURCES)
    file(GLOB ARG_SOURCES CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
    list(REMOVE_ITEM ARG_SOURCES ${ARG_SOLVERS})
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_compile_options(${name} PRIVATE -O0)
  set_target_properties(${name} PROPERTIES UNITY_BUILD_BATCH_SIZE 20)
  target_precompile_headers(${name} REUSE_FROM conformal_test_headers)
  target_link_libraries(${name} PRIVATE GTest::gtest_main)
  set(parts ${name})
  if(ARG_SOLVERS)
    add_library(${name}_solvers OBJECT ${ARG_SOLVERS})
    target_link_libraries(${name} PRIVATE ${name}_solvers)
    list(APPEND parts ${name}_solvers)
  endif()
  foreach(part ${parts})
    target_link_libraries(${part} PRIVATE conformal_options ${ARG_ROOMS} ${ARG_LIBRARIES}
                          conformal_test_options fmt::fmt GTest::gmock)
    target_compile_definitions(${part} PRIVATE
      CONFORMAL_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
      CONFORMAL_BINARY_DIR="${PROJECT_BINARY_DIR}")
  endforeach()
  # COST: those with many sources take long and begin first, so that none runs alone at the end.
  list(LENGTH ARG_SOURCES cost)
  add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
  set_tests_properties(${name} PROPERTIES TIMEOUT 1200 COST ${cost})
endfunction()
