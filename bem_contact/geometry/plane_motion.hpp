#pragma once

#include "bem_contact/geometry/placement.hpp"

namespace bem_contact {

/// A rigid motion in the plane of the sections: a body is turned by `angle` about one of its points, and that
/// point is moved.
struct PlaneMotion {
  Point2 about;     ///< the point, where it was, mm, track frame
  Point2 by;        ///< how far it moves, mm
  double angle = 0; ///< rad, y towards z (about +x)

  Point2 of(Point2 p) const { return Pose{about + by, angle}.to_track(p - about); }
  /// Where a point that has moved to p was.
  Point2 before(Point2 p) const { return about + Pose{about + by, angle}.to_section(p); }
  Pose of(const Pose& pose) const { return {of(pose.origin), pose.angle + angle}; }
  /// How far p moves, to first order in the angle.
  Point2 displacement(Point2 p) const {
    const Point2 arm = p - about;
    return by + angle * Point2{-arm.z, arm.y};
  }
};

/// Says where the bodies of a wheel on a rail go when their structures give way, seen from where the scene
/// puts them. The wheel's axle stays: its rim moves against it.
struct StructuralPlacement {
  PlaneMotion rail, wheel;
  /// Then the wheel is moved along y, mm, so that it slides along the rail as the surfaces in contact do.
  double shift_y = 0;
  /// After that the wheel is lowered by this much until it touches again, mm.
  double lowered = 0;
  /// The motions that influence numbers with structural compliance contain, each in its body's section. The
  /// bodies have already been placed by them, so they must not count again.
  PlaneMotion rail_in_numbers, wheel_in_numbers;

  /// Returns the shift of the wheel after its structure's motion.
  Point2 wheel_by() const { return {shift_y, lowered}; }
};

/// Returns by how much a motion within its section moves a point of a body's surface along its own tangent
/// and into the body, mm: y and z of what is returned.
inline Point2 own_displacement(const PlaneMotion& motion, const CurvePoint& at) {
  const Point2 v = motion.displacement(at.position);
  return {dot(v, tangent_of(at.delta)), dot(v, normal_of(at.delta))};
}

/// By how much these displacements move the rail's surface against the wheel's along s and n, mm, at opposite
/// points of the two profiles: y and z of what is returned. The wheel's own s and n are opposite to the
/// rail's.
inline Point2 counted_twice(const WheelOnRail& pair, const StructuralPlacement& by, double rail_s,
                            double wheel_s) {
  const CurvePoint rail = pair.rail.at(rail_s);
  const double delta = rail.delta + pair.rail_pose.angle;
  return own_displacement(by.rail_in_numbers, rail) +
         own_displacement(by.wheel_in_numbers, pair.wheel.at(wheel_s)) -
         by.shift_y * Point2{tangent_of(delta).y, normal_of(delta).y};
}

/// The pair with both bodies moved, the wheel not yet lowered.
inline WheelOnRail moved(WheelOnRail pair, const StructuralPlacement& by) {
  pair.rail_pose = by.rail.of(pair.rail_pose);
  pair.wheel_pose = by.wheel.of(pair.wheel_pose);
  pair.wheel_pose.origin.y += by.shift_y;
  return pair;
}

/// The pair with the wheel turned and moved back, but not lifted: its axle as the scene puts it.
inline WheelOnRail with_wheel_before(WheelOnRail pair, const StructuralPlacement& by) {
  pair.wheel_pose.origin = by.wheel.before(pair.wheel_pose.origin - by.wheel_by());
  pair.wheel_pose.angle -= by.wheel.angle;
  return pair;
}

} // namespace bem_contact
