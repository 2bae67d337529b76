#include "bem_contact/base/interrupt_note.hpp"

#include "bem_contact/base/system/interrupts.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <utility>

namespace bem_contact {

namespace {

// A signal's handler may not allocate or lock, and on Windows it runs beside the program. It finds the note
// ready in one of two buffers, and the next note is written into the other one. Handlers are the process's
// own, so that this is too.
std::array<std::array<char, 1000>, 2> notes;
std::atomic<const char*> current = nullptr;

} // namespace

InterruptNote::InterruptNote(std::string what, std::string how_to_go_on)
    : what_(std::move(what)), how_to_go_on_(std::move(how_to_go_on)) {
  system::write_when_interrupted(current);
}

InterruptNote::~InterruptNote() {
  system::write_no_more();
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
