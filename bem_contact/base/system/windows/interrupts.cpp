#include "bem_contact/base/interrupt_note.hpp"

#include <array>
#include <atomic>
#include <cstring>
#include <fmt/format.h>
#include <io.h>
#include <windows.h>

namespace bem_contact {

namespace {

// A handler runs beside the program, on a thread of its own: it finds the note ready in one of two buffers,
// and the next note is written into the other one.
std::array<std::array<char, 1000>, 2> notes;
std::atomic<const char*> current = nullptr;

BOOL WINAPI write_note(DWORD) {
  if (const char* note = current)
    static_cast<void>(_write(2, note, static_cast<unsigned>(std::strlen(note))));
  return FALSE; // and then what would have been done without a note
}

} // namespace

InterruptNote::InterruptNote(std::string what, std::string how_to_go_on)
    : what_(std::move(what)), how_to_go_on_(std::move(how_to_go_on)) {
  SetConsoleCtrlHandler(write_note, TRUE);
}

InterruptNote::~InterruptNote() {
  SetConsoleCtrlHandler(write_note, FALSE);
  current = nullptr;
}

void InterruptNote::done(std::size_t count, std::size_t total) {
  std::array<char, 1000>& next = notes[current == notes[0].data() ? 1 : 0];
  const auto end = fmt::format_to_n(next.data(), next.size() - 1, "\ninterrupted: {} of {} {} are done. {}\n",
                                    count, total, what_, how_to_go_on_);
  *end.out = '\0';
  current = next.data();
}

} // namespace bem_contact
