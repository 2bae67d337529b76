#pragma once

#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"

#include <span>
#include <vector>

/// What callers who keep no contact locus would ask for.
namespace bem_contact {

/// The touch points of a pair that stays where it is: distances are those there.
inline std::vector<TouchPoint> find_touch_points(WheelOnRail pair) {
  const double before = pair.wheel_pose.origin.z;
  std::vector<TouchPoint> points = lower_to_touch(pair);
  for (TouchPoint& p : points)
    p.distance += pair.wheel_pose.origin.z - before;
  return points;
}

inline std::vector<double> undeformed_distance(const WheelOnRail& pair, std::span<const ContactRow> rows,
                                               std::span<const double> x) {
  return undeformed_distance(pair, rows_on_locus(ContactLocus(pair), rows), rows, x);
}

} // namespace bem_contact
