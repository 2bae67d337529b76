#include "bem_contact/base/system/memory.hpp"

#include <sys/mman.h>

namespace bem_contact::system {

void ask_for_large_pages([[maybe_unused]] void* begin, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(begin, bytes, MADV_HUGEPAGE);
#endif
}

} // namespace bem_contact::system
