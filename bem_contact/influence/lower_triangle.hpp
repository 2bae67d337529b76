#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact {

/// Numbers of the lower triangle of an n x n matrix, its diagonal included.
inline std::size_t lower_size(std::size_t n) {
  return n * (n + 1) / 2;
}

/// visit(row, column) for all entries of an n x n matrix below its diagonal, in tiles: to reach the entry on
/// the other side as well, row by row, would miss the cache at each number of a large matrix.
template <class Visit> void for_each_below_diagonal(std::size_t n, Visit&& visit) {
  constexpr std::size_t tile = 32;
  for (std::size_t rows = 0; rows < n; rows += tile)
    for (std::size_t columns = 0; columns <= rows; columns += tile)
      for (std::size_t row = rows; row < std::min(n, rows + tile); ++row)
        for (std::size_t column = columns; column < std::min(row, columns + tile); ++column)
          visit(row, column);
}

/// Appends the lower triangle, by rows, of a row-major n x n matrix.
inline void append_lower(std::vector<double>& to, std::span<const double> matrix, std::size_t n) {
  for (std::size_t row = 0; row < n; ++row) {
    const auto part = matrix.subspan(row * n, row + 1);
    to.insert(to.end(), part.begin(), part.end());
  }
}

/// The symmetric matrix, row-major, of a lower triangle by rows.
inline void fill_symmetric(std::span<double> matrix, std::span<const double> lower, std::size_t n) {
  for (std::size_t row = 0; row < n; ++row)
    std::copy_n(lower.begin() + static_cast<std::ptrdiff_t>(lower_size(row)), row + 1,
                matrix.begin() + static_cast<std::ptrdiff_t>(row * n));
  for_each_below_diagonal(
      n, [&](std::size_t row, std::size_t column) { matrix[column * n + row] = matrix[row * n + column]; });
}

} // namespace bem_contact
