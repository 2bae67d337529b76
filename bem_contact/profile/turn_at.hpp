#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cmath>
#include <span>

namespace bem_contact {

/// Angle by which the chords turn at point i, rad, >= 0; 0 at both ends.
inline double turn_at(std::span<const Point2> p, std::size_t i) {
  if (i == 0 || i + 1 >= p.size())
    return 0;
  return std::abs(angle_from_to(p[i] - p[i - 1], p[i + 1] - p[i]));
}

} // namespace bem_contact
