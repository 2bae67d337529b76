#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cmath>
#include <span>

namespace bem_contact {

/// Angle by which the chords turn at point i, rad, >= 0; 0 at both ends.
inline double turn_at(std::span<const Point2> p, std::size_t i) {
  if (i == 0 || i + 1 >= p.size())
    return 0;
  const Point2 a = p[i] - p[i - 1], b = p[i + 1] - p[i];
  return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

} // namespace bem_contact
