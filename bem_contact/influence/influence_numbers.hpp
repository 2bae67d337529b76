#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/large_table.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace bem_contact {

/// Influence numbers of one body or of the pair on a regular strip: `rows` rows of elements along s, elements
/// dx by ds. I is the row of the displaced element and J that of the loaded one. The displaced element lies
/// m dx ahead of the loaded one along x, m = 0 .. offsets - 1. Negative m follow from parity(i, j).
/// Frame: one body's own (base/conventions.hpp); of the pair, the contact frame, with tractions on the rail
/// and displacements of the rail less those of the wheel, -u of base/conventions.hpp.
///
/// values[m][3 I + i][3 J + j], row-major: displacement i averaged over element (m, I), mm, under 1 MPa of
/// traction j on element (0, J). Maxwell-Betti: A_ij(m; I, J) = parity(i,j) A_ji(m; J, I).
/// A contact problem on mx columns needs offsets >= mx + 2, in every kind of motion.
/// Plane strain (each row one element, infinitely long along x): offsets = 1 and dx = 0.
///
/// `translational`: the numbers depend on I - J alone (half-spaces, strips of constant curvature) and only
/// these are stored: values[m][I - J + rows - 1][i][j]. Then at(m, I, i, J, j) is one entry for all pairs of
/// rows equally far apart.
struct InfluenceNumbers {
  int offsets = 0;
  int rows = 0;
  double dx = 0; ///< mm
  double ds = 0; ///< mm
  LargeTable<double> values; ///< resize() does not set new ones (base/large_table.hpp)
  bool translational = false;

  double& at(int m, int row_i, int i, int row_j, int j) { return values[index(m, row_i, i, row_j, j)]; }
  double at(int m, int row_i, int i, int row_j, int j) const { return values[index(m, row_i, i, row_j, j)]; }
  std::size_t index(int m, int row_i, int i, int row_j, int j) const {
    const auto n = static_cast<std::size_t>(rows), offset = static_cast<std::size_t>(m);
    if (translational)
      return ((offset * (2 * n - 1) + (row_i - row_j + n - 1)) * 3 + i) * 3 + j;
    return (offset * 3 * n + 3 * row_i + i) * 3 * n + 3 * row_j + j;
  }
  /// Values that offsets, rows and the form ask for.
  std::size_t expected_values() const {
    const auto n = static_cast<std::size_t>(rows);
    return 9 * static_cast<std::size_t>(offsets) * (translational ? 2 * n - 1 : n * n);
  }
  /// Rows {I, J} of every block that is stored, once.
  std::vector<std::pair<int, int>> stored_rows() const {
    std::vector<std::pair<int, int>> pairs;
    if (translational)
      for (int distance = 1 - rows; distance < rows; ++distance)
        pairs.emplace_back(distance > 0 ? distance : 0, distance > 0 ? 0 : -distance);
    else
      for (int row_i = 0; row_i < rows; ++row_i)
        for (int row_j = 0; row_j < rows; ++row_j)
          pairs.emplace_back(row_i, row_j);
    return pairs;
  }
};

/// The same numbers with every pair of rows written out.
inline InfluenceNumbers spelled_out(const InfluenceNumbers& numbers) {
  if (!numbers.translational)
    return numbers;
  InfluenceNumbers table{numbers.offsets, numbers.rows, numbers.dx, numbers.ds, {}};
  table.values.resize(table.expected_values());
  for (int m = 0; m < table.offsets; ++m)
    for (const auto& [row_i, row_j] : table.stored_rows())
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          table.at(m, row_i, i, row_j, j) = numbers.at(m, row_i, i, row_j, j);
  return table;
}

} // namespace bem_contact
