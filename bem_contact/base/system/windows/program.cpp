#include "bem_contact/base/program.hpp"

#include <cstdio>
#include <fcntl.h>
#include <initializer_list>
#include <io.h>
#include <windows.h>

namespace bem_contact {

void keep_freed_memory() {}

/// Texts are UTF-8 (bem_contact/app/windows.manifest), also on the screen, which knows the sequences that
/// move in a line, and lines end as everywhere.
void begin_program(char**) {
  SetConsoleOutputCP(CP_UTF8);
  const HANDLE screen = GetStdHandle(STD_ERROR_HANDLE);
  if (DWORD mode = 0; GetConsoleMode(screen, &mode))
    SetConsoleMode(screen, mode | ENABLE_VIRTUAL_TERMINAL_PROCESSING);
  for (std::FILE* stream : {stdout, stderr})
    _setmode(_fileno(stream), _O_BINARY);
}

} // namespace bem_contact
