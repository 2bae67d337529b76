#pragma once

#include "bem_contact/base/conventions.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// A measured point that lies off the smooth line through its neighbours.
struct Outlier {
  Point2 point;        ///< mm
  double distance = 0; ///< from that line, mm
};

/// Single points in walking order that lie off the cubic through two neighbours on either side, while each of
/// these neighbours lies on the cubic through its own neighbours without that point. At a corner they do not.
/// `scatter`: of the points, mm (profile_noise.hpp).
std::vector<Outlier> outliers(std::span<const Point2> points, double scatter);

} // namespace bem_contact
