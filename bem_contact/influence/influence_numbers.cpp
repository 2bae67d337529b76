#include "bem_contact/influence/influence_numbers.hpp"

#include <algorithm>

namespace bem_contact {

void NumberLines::write_to(InfluenceNumbers& numbers) const {
  constexpr int block = 8; // offsets of a cache line
  const std::size_t size = 3 * static_cast<std::size_t>(numbers.rows), table = size * size,
                    own = 3 * static_cast<std::size_t>(row_);
  for (int from = 0; from < offsets_; from += block) {
    double* first = numbers.values.data() + static_cast<std::size_t>(from) * table;
    const auto count = static_cast<std::size_t>(std::min(block, offsets_ - from));
    for (int column = 0; column <= row_; ++column)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < (column == row_ ? i + 1 : 3); ++j) {
          const double* line = &values_[line_index(column, i, j) * offsets_ + from];
          const std::size_t there = 3 * static_cast<std::size_t>(column) + j;
          double *here = first + (own + i) * size + there, *opposite = first + there * size + own + i;
          const double sign = parity(i, j);
          for (std::size_t m = 0; m < count; ++m) {
            here[m * table] = line[m];
            opposite[m * table] = sign * line[m];
          }
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
