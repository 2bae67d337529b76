#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace bem_contact {

/// Where a coordinate lies between the rising lines of a table: the line before it, and the share of the way
/// to the next one. Before the first and behind the last line it is that line.
struct PlaceInTable {
  std::size_t line = 0;
  double share = 0;

  PlaceInTable(const std::vector<double>& lines, double at) {
    if (lines.size() == 1)
      return;
    const auto after = std::ranges::upper_bound(lines, at);
    line = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(after - lines.begin() - 1, 0, std::ssize(lines) - 2));
    share = std::clamp((at - lines[line]) / (lines[line + 1] - lines[line]), 0.0, 1.0);
  }
};

} // namespace bem_contact
