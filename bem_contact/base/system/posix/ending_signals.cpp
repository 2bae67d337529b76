#include "bem_contact/base/ending_signals.hpp"

#include "bem_contact/base/error.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace bem_contact {

namespace {

// A handler may do hardly anything: it writes one byte here, and somebody waits at the other end. Handlers
// are the process's own, so that this is too.
int to_waiting = -1;

extern "C" void note_signal(int) {
  const int before = errno;
  static_cast<void>(!write(to_waiting, "x", 1));
  errno = before;
}

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

} // namespace

struct EndingSignals::Before {
  std::array<int, 2> pipe{-1, -1};
  std::array<struct sigaction, signals.size()> actions{};
};

EndingSignals::EndingSignals() : before_(std::make_unique<Before>()) {
  if (pipe2(before_->pipe.data(), O_CLOEXEC) != 0)
    throw Error("The page cannot be served", "the system opens no more files", "Close other programs.");
  to_waiting = before_->pipe[1];
  struct sigaction action {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i)
    sigaction(signals[i], &action, &before_->actions[i]);
}

EndingSignals::~EndingSignals() {
  for (std::size_t i = 0; i < signals.size(); ++i)
    sigaction(signals[i], &before_->actions[i], nullptr);
  for (const int end : before_->pipe)
    close(end);
}

void EndingSignals::wait() const {
  char byte = 0;
  while (read(before_->pipe[0], &byte, 1) < 0 && errno == EINTR) {
  }
}

} // namespace bem_contact
