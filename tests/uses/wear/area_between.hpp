#pragma once

#include "bem_contact/uses/wear/worn_profile.hpp"

#include <span>

namespace bem_contact::wear {

/// Area between two polygons of equally many points, the second inside the body, mm^2.
inline double area_between(std::span<const Point2> before, std::span<const Point2> after) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < before.size(); ++i)
    sum += cross(after[i + 1] - before[i], after[i] - before[i + 1]) / 2;
  return sum;
}

} // namespace bem_contact::wear
