#include "bem_contact/base/memory.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif

namespace bem_contact {

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_TRIM_THRESHOLD, 256 << 20); // bytes
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // bytes, the most that glibc takes; a larger piece is given back
#endif
}

} // namespace bem_contact
