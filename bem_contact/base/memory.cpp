#include "bem_contact/base/memory.hpp"

#include "bem_contact/base/large_table.hpp"

#if __has_include(<malloc.h>)
#include <malloc.h>
#endif
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <new>

namespace bem_contact {
namespace {

constexpr std::size_t large_page = 2 << 20;              ///< bytes
/// Bytes. Smaller tables lie on the heap, where the next one finds their pages again.
constexpr std::size_t large_table = 16 << 20;
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
  const auto end = reinterpret_cast<std::uintptr_t>(sbrk(0)) / large_page * large_page;
  const auto begin = (end - reserved) / large_page * large_page + large_page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#endif
}

} // namespace

void* allocate_table(std::size_t bytes) {
  if (bytes < large_table)
    return ::operator new(bytes);
  void* table = ::operator new(bytes, std::align_val_t(large_page));
#ifdef MADV_HUGEPAGE
  madvise(table, bytes / large_page * large_page, MADV_HUGEPAGE);
#endif
  return table;
}

void free_table(void* table, std::size_t bytes) noexcept {
  if (bytes < large_table)
    ::operator delete(table);
  else
    ::operator delete(table, std::align_val_t(large_page));
}

void keep_freed_memory() {
#ifdef M_TRIM_THRESHOLD
  mallopt(M_TRIM_THRESHOLD, static_cast<int>(kept));
  mallopt(M_MMAP_THRESHOLD, largest_piece); // a larger piece is given back
#endif
  reserve_large_pages();
}

} // namespace bem_contact
