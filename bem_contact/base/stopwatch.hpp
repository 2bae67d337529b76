#pragma once

#include <chrono>

namespace bem_contact {

/// Wall-clock seconds since it was made.
class Stopwatch {
public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Adds the seconds of its own life to a total.
class TimedScope {
public:
  explicit TimedScope(double& total) : total_(total) {}
  ~TimedScope() { total_ += watch_.seconds(); }
  TimedScope(const TimedScope&) = delete;
  TimedScope& operator=(const TimedScope&) = delete;

private:
  double& total_;
  Stopwatch watch_;
};

} // namespace bem_contact
