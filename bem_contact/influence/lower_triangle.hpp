#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact {

/// Appends the lower triangle, by rows, of a row-major n x n matrix.
inline void append_lower(std::vector<double>& to, std::span<const double> matrix, std::size_t n) {
  for (std::size_t row = 0; row < n; ++row) {
    const auto part = matrix.subspan(row * n, row + 1);
    to.insert(to.end(), part.begin(), part.end());
  }
}

/// The symmetric matrix, row-major, of a lower triangle by rows.
inline void fill_symmetric(std::span<double> matrix, std::span<const double> lower, std::size_t n) {
  const double* value = lower.data();
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column <= row; ++column)
      matrix[row * n + column] = matrix[column * n + row] = *value++;
}

} // namespace bem_contact
