#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <array>
#include <span>
#include <vector>

namespace bem_contact {

/// Influence numbers of one row I with the rows J <= I, by lines: a line is one number (i, j) at all offsets.
/// Lines of numbers even in x lie before those of odd ones, so that each kind is one product of matrices.
class NumberLines {
public:
  struct Entry {
    int i, j;
  };
  static constexpr std::array<Entry, 5> even_entries = {{{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}}};
  static constexpr std::array<Entry, 4> odd_entries = {{{0, 1}, {0, 2}, {1, 0}, {2, 0}}};

  /// For rows 0 .. most - 1, one after the other.
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
