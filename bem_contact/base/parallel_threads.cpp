#include "bem_contact/base/parallel.hpp"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace bem_contact {

/// Where there is no OpenMP: the first part runs here, each other one on a thread of its own.
void call_in_parts(int threads, int count, const void* body,
                   void (*call)(const void* body, int first, int end, int part)) {
  const std::ptrdiff_t parts = std::clamp(count, 1, threads);
  std::exception_ptr thrown;
  std::mutex mutex;
  const auto run = [&](std::ptrdiff_t part) {
    try {
      call(body, static_cast<int>(count * part / parts), static_cast<int>(count * (part + 1) / parts),
           static_cast<int>(part));
    } catch (...) {
      const std::lock_guard lock(mutex);
      thrown = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others; // joined at the end, also where no further one can be started
    for (std::ptrdiff_t part = 1; part < parts; ++part)
      others.emplace_back(run, part);
    run(0);
  }
  if (thrown)
    std::rethrow_exception(thrown);
}

} // namespace bem_contact
