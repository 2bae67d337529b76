# For programs that run where glibc is older than here: this machine's compiler, and the C library of the folder
# CONFORMAL_PARTS/linux/sysroot (tools/makers/portable_parts makes it).
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CONFORMAL_PARTS)
if(NOT CONFORMAL_PARTS)
  set(CONFORMAL_PARTS ${CMAKE_CURRENT_LIST_DIR}/../../../build-portable-parts)
endif()
get_filename_component(CONFORMAL_PARTS ${CONFORMAL_PARTS} ABSOLUTE)
set(CMAKE_SYSROOT ${CONFORMAL_PARTS}/linux/sysroot)
set(CMAKE_C_COMPILER gcc)
set(CMAKE_CXX_COMPILER g++)
execute_process(COMMAND g++ -dumpversion OUTPUT_VARIABLE gcc_version OUTPUT_STRIP_TRAILING_WHITESPACE)

# The C++ headers are those of the compiler, and its libstdc++ is linked statically.
set(CMAKE_CXX_FLAGS_INIT
  "-nostdinc++ -isystem /usr/include/c++/${gcc_version} -isystem /usr/include/x86_64-linux-gnu/c++/${gcc_version}")
# Debian's gcc looks for libraries beside itself first, whatever the sysroot is. Its libgcc_eh.a calls glibc 2.35, so the
# older one is taken.
file(GLOB older_libgcc ${CMAKE_SYSROOT}/usr/lib/gcc/x86_64-linux-gnu/*)
set(libraries ${CMAKE_SYSROOT}/usr/lib/x86_64-linux-gnu)
string(CONCAT link_flags "-B${libraries} -L${older_libgcc} -L${libraries} -L${CMAKE_SYSROOT}/lib/x86_64-linux-gnu "
  "-static-libstdc++ -static-libgcc -pthread")
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "${link_flags}")
endforeach()
set(CMAKE_FIND_ROOT_PATH ${CONFORMAL_PARTS}/linux)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_CROSSCOMPILING_EMULATOR env) # what is compiled so runs here, too
