#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/geometry/vector3.hpp"

#include <cmath>

namespace bem_contact {

/// The wheel as it stands: the centre of its tape circle on the axle, and three unit vectors that are the
/// track's x, y, z where it is neither rolled nor yawed.
struct WheelFrame {
  Vector3 centre{}, forward{}, axle{}, down{}; ///< mm; unit vectors
};

/// The rail of a roller rig: a surface of revolution, whose axis is parallel to y and lies below x = 0.
///
/// It is looked at unrolled. The half-plane through the axis at the angle phi from the upward vertical
/// (growing forwards) holds the rail's profile, as the plane x = const does on a track. A point of it at the
/// distance d from the axis is at (x, y, z) = (d phi, y, axis - d), and e_x is the direction in which the
/// roller's circle runs there. So on the roller's surface x is the length of arc, and the rail's normal has
/// no component along x.
struct Roller {
  double axis = 0; ///< z of it, mm

  double radius(Point2 p) const { return axis - p.z; } ///< of the circle through an unrolled point, mm
  double angle(double x, Point2 p) const { return x / radius(p); } ///< phi there, rad

  /// Where an unrolled point is in space.
  Vector3 in_space(double x, Point2 p) const {
    const double phi = angle(x, p), d = radius(p);
    return {d * std::sin(phi), p.y, axis - d * std::cos(phi)};
  }
  /// A point in space, unrolled.
  Vector3 unrolled(const Vector3& p) const {
    const double d = std::hypot(p[0], axis - p[2]);
    return {d * std::atan2(p[0], axis - p[2]), p[1], axis - d};
  }
  /// Components of a vector in the frame of the half-plane at phi.
  static Vector3 seen(const Vector3& v, double phi) {
    const double c = std::cos(phi), s = std::sin(phi);
    return {c * v[0] + s * v[2], v[1], c * v[2] - s * v[0]};
  }
  /// The wheel as it is seen from that half-plane: turned back by phi about the axis.
  WheelFrame seen(const WheelFrame& f, double phi) const {
    const Vector3 arm = seen(Vector3{f.centre[0], f.centre[1], f.centre[2] - axis}, phi);
    return {{arm[0], arm[1], axis + arm[2]}, seen(f.forward, phi), seen(f.axle, phi), seen(f.down, phi)};
  }
};

} // namespace bem_contact
