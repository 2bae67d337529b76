#include "bem_contact/base/memory.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace bem_contact {
namespace {

constexpr std::size_t kept = std::size_t(512) << 20;     ///< bytes
constexpr std::size_t reserved = std::size_t(256) << 20; ///< bytes
constexpr int usual_top_pad = 128 << 10;                 ///< bytes, as mallopt(3) has it
constexpr int largest_piece = 32 << 20;                  ///< bytes, the most that glibc takes

/// Asks for large pages, 2 MB each, on a heap that no one has touched yet. The first touch of a page costs a change to
/// the kernel and back; large ones cost a hundredth of that for each byte. Nothing is used before it is touched, and
/// where large pages cannot be had all is as before.
void reserve_large_pages() {
#if defined(M_TOP_PAD) && defined(MADV_HUGEPAGE)
  mallopt(M_TOP_PAD, static_cast<int>(reserved)); // the heap grows by so much beyond what is asked for
  void* volatile grown = std::malloc(1 << 20);    // volatile: or the compiler leaves both calls out
  std::free(grown);
  mallopt(M_TOP_PAD, usual_top_pad);
  constexpr std::uintptr_t page = 2 << 20;
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / page * page;
  const auto begin = (end - reserved) / page * page + page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_TRIM_THRESHOLD, static_cast<int>(kept));
  mallopt(M_MMAP_THRESHOLD, largest_piece); // a larger piece is given back
#endif
  reserve_large_pages();
}

} // namespace bem_contact
