#pragma once

#include "bem_contact/contact/problem.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace bem_contact::contact {

/// A rectangle of the grid.
struct Box {
  int first_x = 0, first_s = 0, mx = 0, ms = 0;

  int size() const { return mx * ms; }
  bool contains(int x, int s) const {
    return x >= first_x && x < first_x + mx && s >= first_s && s < first_s + ms;
  }
};

/// Boxes of one size around the elements that matter, one for each group of rows that lie far apart:
/// operators on them are smaller than on the grid. Fields on them are [box][ms][mx].
struct Parts {
  std::vector<Box> boxes; ///< at least one; along s

  int mx() const { return boxes.front().mx; }
  int ms() const { return boxes.front().ms; } ///< of one box
  int count() const { return static_cast<int>(boxes.size()); }
  int rows() const { return count() * ms(); } ///< of all
  int size() const { return count() * boxes.front().size(); }
  /// The number in a field of an element of the grid, whose rows have `grid_mx`; -1 outside.
  int local(int element, int grid_mx) const {
    const int x = element % grid_mx, s = element / grid_mx;
    for (int k = 0; k < count(); ++k)
      if (boxes[k].contains(x, s))
        return (k * ms() + s - boxes[k].first_s) * mx() + x - boxes[k].first_x;
    return -1;
  }
  std::vector<int> local(std::span<const int> elements, int grid_mx) const {
    std::vector<int> numbers(elements.size());
    std::transform(elements.begin(), elements.end(), numbers.begin(),
                   [&](int element) { return local(element, grid_mx); });
    return numbers;
  }
  bool cover(std::span<const int> elements, int grid_mx) const {
    return std::ranges::all_of(elements, [&](int element) { return local(element, grid_mx) >= 0; });
  }
};

/// Around the elements, of which there is at least one, widened by `margin` inside the grid. One box where
/// several would save little. `columns`: all boxes have the same columns.
Parts parts_around(std::span<const int> elements, const ContactGrid& grid, int margin, bool columns);

/// Whether kept parts serve these elements, for which `needed` would be made: around them, not much larger.
inline bool serve(const Parts& kept, const Parts& needed, std::span<const int> elements, int grid_mx) {
  constexpr double much = 2.5;
  return kept.size() <= much * needed.size() + 64 && kept.cover(elements, grid_mx);
}

} // namespace bem_contact::contact
