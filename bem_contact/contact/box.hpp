#pragma once

#include "bem_contact/contact/problem.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// A rectangle of the grid, around the elements that matter: operators on it are smaller than on the grid.
struct Box {
  int first_x = 0, first_s = 0, mx = 0, ms = 0;

  int size() const { return mx * ms; }
  /// The box's number of an element of the grid, whose rows have `grid_mx`.
  int local(int element, int grid_mx) const {
    return (element / grid_mx - first_s) * mx + element % grid_mx - first_x;
  }
  bool contains(const Box& b) const {
    return b.first_x >= first_x && b.first_s >= first_s && b.first_x + b.mx <= first_x + mx &&
           b.first_s + b.ms <= first_s + ms;
  }
  std::vector<int> local(std::span<const int> elements, int grid_mx) const {
    std::vector<int> numbers(elements.size());
    std::transform(elements.begin(), elements.end(), numbers.begin(),
                   [&](int element) { return local(element, grid_mx); });
    return numbers;
  }
};

/// The smallest box around the elements, of which there is at least one, widened by `margin` inside the grid.
inline Box box_around(std::span<const int> elements, const ContactGrid& grid, int margin = 0) {
  int low_x = grid.mx, high_x = 0, low_s = grid.ms, high_s = 0;
  for (const int i : elements) {
    low_x = std::min(low_x, i % grid.mx);
    high_x = std::max(high_x, i % grid.mx);
    low_s = std::min(low_s, i / grid.mx);
    high_s = std::max(high_s, i / grid.mx);
  }
  low_x = std::max(low_x - margin, 0);
  low_s = std::max(low_s - margin, 0);
  high_x = std::min(high_x + margin, grid.mx - 1);
  high_s = std::min(high_s + margin, grid.ms - 1);
  return {low_x, low_s, high_x - low_x + 1, high_s - low_s + 1};
}

} // namespace bem_contact::contact
