#pragma once

#include <atomic>
#include <stdexcept>

namespace bem_contact {

/// Somebody asked for the end of a computation (Ctrl-C). This is no error of the input or of convergence.
class Stopped : public std::runtime_error {
public:
  Stopped() : std::runtime_error("the computation was stopped before its end") {}
};

/// Throws Stopped if another thread has set `stop`. Null: nobody does.
inline void end_if_stopped(const std::atomic<bool>* stop) {
  if (stop && *stop)
    throw Stopped();
}

} // namespace bem_contact
