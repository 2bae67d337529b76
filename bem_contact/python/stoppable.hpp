#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace bem_contact {

/// While one lives, other threads of Python run: it holds Python's lock no longer. If Python ends meanwhile,
/// its destructor never returns: a thread that asks for the lock then would be unwound through frames of C++
/// that cannot be, and the process would abort. Such threads are daemons; the process ends without them.
class OthersMayRun {
public:
  OthersMayRun();
  ~OthersMayRun();
  OthersMayRun(const OthersMayRun&) = delete;
  OthersMayRun& operator=(const OthersMayRun&) = delete;

private:
  std::optional<pybind11::gil_scoped_release> released_;
};

/// Lives while Python is in a function of this module. Where Python ends, its constructor never returns in
/// any other thread: such threads are daemons.
class CallFromPython {
public:
  CallFromPython();
  ~CallFromPython();
  CallFromPython(const CallFromPython&) = delete;
  CallFromPython& operator=(const CallFromPython&) = delete;
};

/// Runs `work` in another thread, without Python's lock, while this one looks for Ctrl-C. Then the call ends
/// at once with what the signal's handler raises, and `work` gets a flag that tells it to stop. It may
/// outlive the call and so owns what it needs. Throws what `work` throws, and Error in a process that was
/// forked while another thread was solving.
void run_stoppable(std::function<void(const std::atomic<bool>*)> work);

/// The same for work with a result.
template <class Work> auto stoppable(Work work) {
  using Result = std::invoke_result_t<Work, const std::atomic<bool>*>;
  const auto result = std::make_shared<std::optional<Result>>();
  run_stoppable([result, work = std::move(work)](const std::atomic<bool>* stop) { *result = work(stop); });
  return std::move(**result);
}

/// Tells all work to stop and waits until it has, and until no thread waits for Python's lock or is in a
/// function of this module. Python calls it before it ends.
void end_all_solutions();
/// For processes that are forked while a thread solves.
void watch_forks();

} // namespace bem_contact
