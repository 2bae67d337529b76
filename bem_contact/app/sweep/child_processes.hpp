#pragma once

#include "bem_contact/base/workers.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>

namespace bem_contact::app {

/// How many processes --jobs means; 0: one for each core.
std::size_t processes_of(int jobs);

/// How a child process has ended.
struct EndOfChild {
  CaseRange cases; ///< that it was to solve
  int code = -1;   ///< what `work` returned; -1: a signal has ended it
  std::string how; ///< "was ended by signal 9 (Killed)"
};

/// Workers that solve cases side by side.
class ChildProcesses {
public:
  std::size_t size() const { return workers_.size(); }
  /// Throws Error if no process can be started.
  void start(CaseRange cases, const std::function<int()>& work);
  /// Waits until one ends.
  EndOfChild wait();

private:
  Workers workers_;
  std::map<std::size_t, CaseRange> cases_; ///< that they solve, by the first
};

} // namespace bem_contact::app
