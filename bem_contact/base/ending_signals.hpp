#pragma once

#include <memory>

namespace bem_contact {

/// While the object lives, what ends a program (Ctrl-C; SIGTERM and SIGHUP; on Windows a closed window) is
/// waited for instead. One object at a time. Throws Error where the system opens no more files.
class EndingSignals {
public:
  EndingSignals();
  ~EndingSignals();
  EndingSignals(const EndingSignals&) = delete;
  EndingSignals& operator=(const EndingSignals&) = delete;

  void wait() const;

private:
  struct Before;
  std::unique_ptr<Before> before_;
};

} // namespace bem_contact
