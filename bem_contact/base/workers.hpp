#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace bem_contact {

/// How a worker has ended.
struct EndOfWork {
  std::size_t number = 0; ///< that start() was given
  int code = -1;          ///< what `work` returned; -1: a signal has ended it
  std::string how;        ///< "the process that solved it was ended by signal 9 (Killed)"
};

/// Work side by side: in child processes, because a case that kills its process then costs little. They end
/// when this process ends. On Windows, which cannot copy a process, workers are threads.
class Workers {
public:
  /// `temporary`: where children make their temporary folders. They may be killed, and whoever made this one
  /// removes what they leave. "": where this process makes its own, if they make any.
  explicit Workers(std::filesystem::path temporary = {});
  ~Workers(); ///< ends those that are left; threads are waited for
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  std::size_t size() const;
  /// `number`: of no other worker that is there. Throws Error if none can be started.
  void start(std::size_t number, const std::function<int()>& work);
  /// Waits until one ends.
  EndOfWork wait();

private:
  std::filesystem::path temporary_;
  struct Started;
  std::unique_ptr<Started> started_;
};

} // namespace bem_contact
