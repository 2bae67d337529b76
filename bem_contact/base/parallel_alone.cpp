#include "bem_contact/base/parallel.hpp"

namespace bem_contact {

/// Where there is no OpenMP.
void call_in_parts(int, int count, const void* body,
                   void (*call)(const void* body, int first, int end, int part)) {
  call(body, 0, count, 0);
}

} // namespace bem_contact
