#include "bem_contact/base/parallel.hpp"

#include <algorithm>
#include <omp.h>

namespace bem_contact {

void in_parts(int threads, int count, const std::function<void(int, int, int)>& body) {
  threads = std::min(threads, count);
  if (threads <= 1) {
    body(0, count, 0);
    return;
  }
#pragma omp parallel num_threads(threads)
  {
    const auto part = static_cast<long>(omp_get_thread_num()), parts = static_cast<long>(omp_get_num_threads());
    body(static_cast<int>(count * part / parts), static_cast<int>(count * (part + 1) / parts),
         static_cast<int>(part));
  }
}

} // namespace bem_contact
