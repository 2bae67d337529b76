#pragma once

#include "bem_contact/geometry/placement.hpp"

#include <numbers>
#include <vector>

namespace bem_contact::shapes {

/// An arc of a circle in a section, walked with growing delta = from .. to; the lowest point (upper body) or
/// the highest (lower body) is at the origin. Radius > 0: convex body.
inline ProfileCurve rail_arc(double radius, double half_angle) {
  std::vector<Point2> points;
  for (int i = -400; i <= 400; ++i) {
    const double a = half_angle * i / 400;
    points.push_back({radius * std::sin(a), radius * (1 - std::cos(a))});
  }
  return ProfileCurve::through_points("rail arc", points);
}

inline ProfileCurve wheel_arc(double radius, double half_angle) {
  std::vector<Point2> points;
  for (int i = -400; i <= 400; ++i) {
    const double a =
        -std::copysign(half_angle, radius) * i / 400; // from the field side (+y) to the flange (-y)
    points.push_back({radius * std::sin(a), -radius * (1 - std::cos(a))});
  }
  return ProfileCurve::through_points("wheel arc", points);
}

/// Both arcs with their lowest and highest points above each other at y = 0, wheel of radius `wheel_radius`.
inline WheelOnRail arcs(double rail_radius, double wheel_profile_radius, double wheel_radius,
                        double half_angle = 1.0) {
  return {
      rail_arc(rail_radius, half_angle), wheel_arc(wheel_profile_radius, half_angle), {}, {}, wheel_radius};
}

/// On a track whose rails lean by 1:40.
inline WheelsetPosition standing(double lateral, double yaw = 0, double along = 0) {
  WheelsetPosition position;
  position.lateral = lateral;
  position.yaw = yaw;
  position.rail_inclination = 0.025;
  position.uneven.along = along;
  return position;
}

} // namespace bem_contact::shapes
