#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/large_table.hpp"

#include <array>
#include <cstddef>
#include <span>
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
  double dx = 0;             ///< mm
  double ds = 0;             ///< mm
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

/// Returns the same numbers with every pair of rows written out.
inline InfluenceNumbers with_every_pair_of_rows(const InfluenceNumbers& numbers) {
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

/// Influence numbers of one row I with the rows J <= I, by lines: a line is one number (i, j) at all offsets.
/// Lines of numbers even in x lie before those of odd ones, so that each kind is one product of matrices.
class NumberLines {
public:
  struct Entry {
    int i, j;
  };
  static constexpr std::array<Entry, 5> even_entries = {{{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}}};
  static constexpr std::array<Entry, 4> odd_entries = {{{0, 1}, {0, 2}, {1, 0}, {2, 0}}};

  /// Makes lines for rows 0 .. most - 1, one after the other.
  NumberLines(int most, int offsets)
      : offsets_(offsets), values_(static_cast<std::size_t>(9) * most * offsets) {}

  void begin(int row) { row_ = row; }

  int row() const { return row_; }         ///< I
  int columns() const { return row_ + 1; } ///< how many J
  int offsets() const { return offsets_; }

  /// A_ij(m; I, J), m = 0, 1, ...; on the diagonal (J = I) those with i < j are not read.
  std::span<double> line(int column, int i, int j) {
    return {values_.data() + line_index(column, i, j) * offsets_, static_cast<std::size_t>(offsets_)};
  }
  /// All even lines, [5 J + e][m] with e as in even_entries, and the odd ones, [4 J + e][m].
  double* even() { return values_.data(); }
  double* odd() { return values_.data() + even_entries.size() * columns() * offsets_; }

  /// Writes them into the table, and by Maxwell-Betti those on the other side of the diagonal.
  void write_to(InfluenceNumbers& numbers) const;
  void read_from(const InfluenceNumbers& numbers);

private:
  std::size_t line_index(int column, int i, int j) const {
    constexpr std::size_t place[3][3] = {{0, 0, 1}, {2, 1, 2}, {3, 3, 4}}; // in the lists of entries
    return parity(i, j) > 0 ? even_entries.size() * column + place[i][j]
                            : even_entries.size() * columns() + odd_entries.size() * column + place[i][j];
  }

  int row_ = 0, offsets_;
  std::vector<double> values_;
};

} // namespace bem_contact
