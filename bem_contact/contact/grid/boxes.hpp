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

/// Boxes of one size around some elements, one for each group of rows that lie far apart. Operators on them
/// are smaller than those on the grid. Fields on them are [box][ms][mx].
struct Boxes {
  std::vector<Box> boxes; ///< at least one; along s

  int mx() const { return boxes.front().mx; }
  int ms() const { return boxes.front().ms; } ///< of one box
  int count() const { return static_cast<int>(boxes.size()); }
  int rows() const { return count() * ms(); } ///< of all
  int size() const { return count() * boxes.front().size(); }
  /// Place in a field on the boxes of an element of the grid, which has `grid_mx` columns; -1 outside.
  int local(int element, int grid_mx) const;
  std::vector<int> local(std::span<const int> elements, int grid_mx) const;
  bool cover(std::span<const int> elements, int grid_mx) const;
};

/// Around the elements, of which there is at least one, widened by `margin` inside the grid. One box where
/// several would save little. `same_columns`: all boxes have the same columns.
Boxes boxes_around(std::span<const int> elements, const ContactGrid& grid, int margin, bool same_columns);

/// Says whether boxes made earlier serve these elements: they cover them, and are not much larger than
/// `needed`, the boxes that would be made for them.
bool serve(const Boxes& earlier, const Boxes& needed, std::span<const int> elements, int grid_mx);

} // namespace bem_contact::contact
