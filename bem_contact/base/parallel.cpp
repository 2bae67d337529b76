#include "bem_contact/base/parallel.hpp"

#include <algorithm>
#include <omp.h>

namespace bem_contact {

void call_in_parts(int threads, int count, const void* body,
                   void (*call)(const void* body, int first, int end, int part)) {
#pragma omp parallel num_threads(std::clamp(count, 1, threads))
  {
    const auto part = static_cast<long>(omp_get_thread_num()),
               parts = static_cast<long>(omp_get_num_threads());
    call(body, static_cast<int>(count * part / parts), static_cast<int>(count * (part + 1) / parts),
         static_cast<int>(part));
  }
}

} // namespace bem_contact
