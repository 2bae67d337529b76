#pragma once

#include "bem_contact/scene/sweep_file.hpp"

#include <sys/types.h>

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

/// Processes that solve cases side by side. We use processes, not threads, because FFTW's planner and HDF5
/// are not safe with threads, and because a case that kills its process then costs little. They end when this
/// process ends.
class ChildProcesses {
public:
  ChildProcesses() = default;
  ~ChildProcesses(); ///< kills those that are left
  ChildProcesses(const ChildProcesses&) = delete;
  ChildProcesses& operator=(const ChildProcesses&) = delete;

  std::size_t size() const { return started_.size(); }
  /// Throws Error if no process can be started.
  void start(CaseRange cases, const std::function<int()>& work);
  /// Waits until one ends.
  EndOfChild wait();

private:
  std::map<pid_t, CaseRange> started_;
};

} // namespace bem_contact::app
