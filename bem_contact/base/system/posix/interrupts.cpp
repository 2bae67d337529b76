#include "bem_contact/base/system/interrupts.hpp"

#include <unistd.h>

#include <csignal>
#include <cstring>

namespace bem_contact::system {

namespace {

const std::atomic<const char*>* shown = nullptr;
pid_t owner = 0;
struct sigaction before_int {
}, before_term{};

extern "C" void write_note(int signal) {
  const char* note = *shown;
  if (note && getpid() == owner)
    static_cast<void>(!write(STDERR_FILENO, note, std::strlen(note)));
  sigaction(signal, signal == SIGINT ? &before_int : &before_term, nullptr);
  raise(signal); // what would have been done without a note is done when this handler returns
}

} // namespace

void write_when_interrupted(const std::atomic<const char*>& note) {
  shown = &note;
  owner = getpid();
  struct sigaction action {};
  action.sa_handler = write_note;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &before_int);
  sigaction(SIGTERM, &action, &before_term);
}

void write_no_more() {
  sigaction(SIGINT, &before_int, nullptr);
  sigaction(SIGTERM, &before_term, nullptr);
}

} // namespace bem_contact::system
