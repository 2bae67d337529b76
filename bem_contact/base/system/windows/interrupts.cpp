#include "bem_contact/base/system/interrupts.hpp"

#include <cstring>
#include <io.h>
#include <windows.h>

namespace bem_contact::system {

namespace {

const std::atomic<const char*>* shown = nullptr;

BOOL WINAPI write_note(DWORD) { // on a thread of its own
  if (const char* note = *shown)
    static_cast<void>(_write(2, note, static_cast<unsigned>(std::strlen(note))));
  return FALSE; // and then what would have been done without a note
}

} // namespace

void write_when_interrupted(const std::atomic<const char*>& note) {
  shown = &note;
  SetConsoleCtrlHandler(write_note, TRUE);
}

void write_no_more() {
  SetConsoleCtrlHandler(write_note, FALSE);
}

} // namespace bem_contact::system
