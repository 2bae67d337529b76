#include "bem_contact/base/interrupt_note.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

namespace bem_contact {

namespace {

// A signal's handler may not allocate or lock. It finds the note ready in one of two buffers, and the next
// note is written into the other one. Handlers are the process's own, so that this is too.
std::array<std::array<char, 1000>, 2> notes;
std::atomic<const char*> current = nullptr;
pid_t owner = 0;
struct sigaction before_int {
}, before_term{};

extern "C" void write_note(int signal) {
  const char* note = current;
  if (note && getpid() == owner)
    static_cast<void>(!write(STDERR_FILENO, note, std::strlen(note)));
  sigaction(signal, signal == SIGINT ? &before_int : &before_term, nullptr);
  raise(signal); // what would have been done without a note is done when this handler returns
}

} // namespace

InterruptNote::InterruptNote(std::string what, std::string how_to_go_on)
    : what_(std::move(what)), how_to_go_on_(std::move(how_to_go_on)) {
  owner = getpid();
  struct sigaction action {};
  action.sa_handler = write_note;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_int);
  sigaction(SIGTERM, &action, &before_term);
}

InterruptNote::~InterruptNote() {
  sigaction(SIGINT, &before_int, nullptr);
  sigaction(SIGTERM, &before_term, nullptr);
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
