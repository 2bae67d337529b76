#pragma once

#include "bem_contact/geometry/placement.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The contact locus: the curve on the wheel where its normal lies in the track's yz-plane. A rail is the
/// same all along x, so that the wheel touches it nowhere else (Li and Kalker 1998), and what is left is the
/// locus, seen along x, against the profile of the rail. Without yaw it is the profile in the plane x = 0.
///
/// On the meridian of arc length s it is at the angle theta from the axle's downward direction d to its
/// forward direction f where n_r (cos theta d_x + sin theta f_x) + n_y a_x = 0, (n_y, n_r) the profile's
/// outward normal and a the axle. There is none where the profile is steeper than the yaw allows. At an edge
/// (a convex kink of the profile) the normal turns while s stays.
class ContactLocus {
public:
  explicit ContactLocus(const WheelOnRail& pair);

  struct Point {
    double s = 0;    ///< arc length on the wheel's profile, mm
    double x = 0;    ///< mm
    Point2 position; ///< (y, z), mm
  };
  /// In walking order, from the field side to the flange: at most 0.1 mm of s apart. A node that begins a
  /// stretch of its own has `joined` false.
  struct Node : Point {
    Point2 tangent;     ///< of the profile, in its section
    bool joined = true; ///< to the node before it
    int interval = 0;   ///< of the profile's table: the one that follows the node
  };
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Between nodes k and k + 1, 0 <= t <= 1 (joined ones).
  Point between(int k, double t) const;
  /// Curvature of the wheel along x there, positive where it is convex (1 / radius on the tread), 1/mm.
  double curvature_along_x(int k, double t) const;
  /// At an arc length of the wheel's profile, with the inclination of the surface in the track frame (near pi
  /// on the tread) and the curvature of the profile; nothing where there is no locus.
  std::optional<CurvePoint> at(double s) const;

  const WheelFrame& frame() const { return frame_; }

private:
  std::optional<Point> point(double s, Point2 position, Point2 tangent) const;

  TabulatedProfile wheel_;
  double radius_ = 0;
  WheelFrame frame_;
  std::vector<Node> nodes_;
};

} // namespace bem_contact
