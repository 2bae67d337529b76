#pragma once

#include <array>
#include <cstddef>

/// Private to this room.
namespace bem_contact::halfspace {

/// A weighted sum of lines: a line is one influence number at all offsets. What is mixed are blocks of nine
/// lines [i][j][m], one after the other.
struct LineMix {
  static constexpr std::size_t most = 11; ///< blocks
  std::size_t count = 0;
  std::array<const double*, most> block{};
  std::array<double, most> weight{};

  void add(const double* from, double factor) {
    if (factor != 0) {
      block[count] = from;
      weight[count++] = factor;
    }
  }
};

/// line = factor line + the mix of the blocks' lines `shift` values after their beginning.
void add_mix(const LineMix& mix, std::size_t shift, double factor, double* line, std::size_t offsets);

} // namespace bem_contact::halfspace
