#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace bem_contact {

/// Runs `work` in another thread, without Python's lock, while this one looks for Ctrl-C. Then the call ends
/// at once with what the signal's handler raises, and `work` gets a flag that tells it to stop. It may
/// outlive the call and so owns what it needs. Throws what `work` throws.
void run_stoppable(std::function<void(const std::atomic<bool>*)> work);

/// The same for work with a result.
template <class Work> auto stoppable(Work work) {
  using Result = std::invoke_result_t<Work, const std::atomic<bool>*>;
  const auto result = std::make_shared<std::optional<Result>>();
  run_stoppable([result, work = std::move(work)](const std::atomic<bool>* stop) { *result = work(stop); });
  return std::move(**result);
}

/// Waits for work that was stopped and has not noticed yet. Python calls it before it ends.
void end_stopped_solutions();

} // namespace bem_contact
