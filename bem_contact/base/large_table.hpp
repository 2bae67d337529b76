#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace bem_contact {

inline constexpr std::size_t large_page = 2 << 20; ///< bytes

/// Memory for a large table, in large pages where the system has them; free_table() gives it back. Throws
/// std::bad_alloc.
void* allocate_table(std::size_t bytes);
void free_table(void* table, std::size_t bytes) noexcept;

/// Allocates the values of a LargeTable.
template <class T> struct TableAllocator {
  using value_type = T;
  TableAllocator() = default;
  template <class Other> TableAllocator(const TableAllocator<Other>& /*other*/) {}

  T* allocate(std::size_t n) { return static_cast<T*>(allocate_table(n * sizeof(T))); }
  void deallocate(T* table, std::size_t n) noexcept { free_table(table, n * sizeof(T)); }
  template <class U> void construct(U* at) { ::new (static_cast<void*>(at)) U; }
  template <class U, class... Arguments> void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
  bool operator==(const TableAllocator&) const = default;
};

/// A vector for megabytes of values. New values of resize(n) are not set, since clearing them takes as long
/// as writing them; resize(n, 0.0) and assign(n, 0.0) set them.
template <class T> using LargeTable = std::vector<T, TableAllocator<T>>;

} // namespace bem_contact
