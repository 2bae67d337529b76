#include "bem_contact/base/large_table.hpp"

#include "bem_contact/base/system/memory.hpp"

namespace bem_contact {

namespace {

/// Bytes, some large pages. Smaller tables lie on the heap, where the next one finds their pages again.
/// Chosen.
constexpr std::size_t own_pages = 16 << 20;

} // namespace

void* allocate_table(std::size_t bytes) {
  if (bytes < own_pages)
    return ::operator new(bytes);
  void* table = ::operator new(bytes, std::align_val_t(large_page));
  system::ask_for_large_pages(table, bytes / large_page * large_page);
  return table;
}

void free_table(void* table, std::size_t bytes) noexcept {
  if (bytes < own_pages)
    ::operator delete(table);
  else
    ::operator delete(table, std::align_val_t(large_page));
}

} // namespace bem_contact
