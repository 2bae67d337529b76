#include "bem_contact/influence/number_lines.hpp"

#include <algorithm>

namespace bem_contact {

void NumberLines::write_to(InfluenceNumbers& numbers) const {
  constexpr int block = 8; // offsets of a cache line
  const std::size_t size = 3 * static_cast<std::size_t>(numbers.rows),
                    own = 3 * static_cast<std::size_t>(row_);
  for (int from = 0; from < offsets_; from += block)
    for (int m = from; m < std::min(from + block, offsets_); ++m) {
      double* table = numbers.values.data() + static_cast<std::size_t>(m) * size * size;
      for (int column = 0; column <= row_; ++column)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < (column == row_ ? i + 1 : 3); ++j) {
            const double value = values_[line_index(column, i, j) * offsets_ + m];
            const std::size_t there = 3 * static_cast<std::size_t>(column) + j;
            table[(own + i) * size + there] = value;
            table[there * size + own + i] = parity(i, j) * value;
          }
    }
}

void NumberLines::read_from(const InfluenceNumbers& numbers) {
  for (int column = 0; column <= row_; ++column)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int m = 0; m < numbers.offsets; ++m)
          line(column, i, j)[m] = numbers.at(m, row_, i, column, j);
}

} // namespace bem_contact
