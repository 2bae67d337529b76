# conformal_host_headers(NAME ...): of /usr/include those folders alone that serve any machine, by the targets that Debian's
# packages have. They lie in a folder of their own: in /usr/include the headers of this machine's C library would hide those of
# the one that is compiled for.
function(conformal_host_headers)
  add_library(conformal_headers INTERFACE)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/headers)
  foreach(name ${ARGN})
    if(NOT EXISTS /usr/include/${name})
      message(FATAL_ERROR "There is no /usr/include/${name} (this preset needs it) run tools/install_packages")
    endif()
    file(CREATE_LINK /usr/include/${name} ${CMAKE_BINARY_DIR}/headers/${name} SYMBOLIC)
  endforeach()
  target_include_directories(conformal_headers SYSTEM INTERFACE ${CMAKE_BINARY_DIR}/headers /usr/include/eigen3)
  target_compile_definitions(conformal_headers INTERFACE FMT_HEADER_ONLY SPDLOG_FMT_EXTERNAL)
  foreach(target Eigen3::Eigen fmt::fmt spdlog::spdlog nlohmann_json::nlohmann_json CLI11::CLI11)
    add_library(${target} ALIAS conformal_headers)
  endforeach()
endfunction()
