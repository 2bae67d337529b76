#include "bem_contact/base/program.hpp"

#include <cstdio>
#include <fcntl.h>
#include <initializer_list>
#include <io.h>
#include <windows.h>

namespace bem_contact {

void keep_freed_memory() {}

/// Texts are UTF-8 (bem_contact/app/windows.manifest), also on the screen, and lines end as everywhere.
void begin_program(char**) {
  SetConsoleOutputCP(CP_UTF8);
  for (std::FILE* stream : {stdout, stderr})
    _setmode(_fileno(stream), _O_BINARY);
}

} // namespace bem_contact
