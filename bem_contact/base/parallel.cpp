#include "bem_contact/base/parallel.hpp"

#include <algorithm>
#include <exception>
#include <omp.h>

namespace bem_contact {

void call_in_parts(int threads, int count, const void* body,
                   void (*call)(const void* body, int first, int end, int part)) {
  std::exception_ptr thrown; // no exception may leave a parallel region
#pragma omp parallel num_threads(std::clamp(count, 1, threads))
  {
    const auto part = static_cast<long>(omp_get_thread_num()),
               parts = static_cast<long>(omp_get_num_threads());
    try {
      call(body, static_cast<int>(count * part / parts), static_cast<int>(count * (part + 1) / parts),
           static_cast<int>(part));
    } catch (...) {
#pragma omp critical
      thrown = std::current_exception();
    }
  }
  if (thrown)
    std::rethrow_exception(thrown);
}

} // namespace bem_contact
