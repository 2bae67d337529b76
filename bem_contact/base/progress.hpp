#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <mutex>
#include <string>

namespace bem_contact {

/// "12.3 s", from 100 s on "2:05 min".
std::string duration_text(double seconds);

/// A progress bar for a long step: label, done of total, time left. On a terminal one line is redrawn at
/// most ten times a second; elsewhere (a file, a CI log) a line is written at most every tenth of the way.
/// Steps may come from several threads.
class Progress {
public:
  /// Reports on standard error.
  Progress(std::string label, std::size_t total);
  /// Reports on any stream, for tests and for programs that have their own.
  Progress(std::string label, std::size_t total, std::ostream& out, bool terminal);
  ~Progress(); ///< ends the line where finish() was not called
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void step(std::size_t count = 1);
  /// So much more has turned out to be done.
  void extend(std::size_t count);
  void finish(); ///< says how long it took; later steps are ignored

private:
  using Clock = std::chrono::steady_clock;
  void draw(bool last);

  std::mutex mutex_;
  std::string label_;
  std::size_t total_, done_ = 0, drawn_ = 0;
  std::ostream& out_;
  bool terminal_, finished_ = false;
  Clock::time_point start_ = Clock::now(), last_draw_ = start_;
};

} // namespace bem_contact
