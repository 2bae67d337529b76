#pragma once

#include "bem_contact/geometry/nearest_along.hpp"
#include "bem_contact/geometry/placement.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// The contact locus: the curve on the wheel where its normal lies in the track's yz-plane. A rail is the
/// same all along x, so that the wheel touches it nowhere else (Li and Kalker 1998), and what is left is the
/// locus, seen along x, against the profile of the rail. Without yaw it is the profile in the plane x = 0.
///
/// The point of the profile at arc length s turns about the axle on a circle. The locus has the point of this
/// circle at the angle theta (0 below the axle, growing forwards) where the normal has no component along x:
///     n_r (cos theta down_x + sin theta forward_x) + n_y axle_x = 0,
/// with the unit vectors of WheelFrame and the profile's outward normal: n_y along the axle, n_r away from
/// it. No angle does that where the profile is steeper than the yaw allows; there is no locus at such an s.
/// On a roller the normal must lie in the half-plane through the roller's axis. With P the point, n the
/// normal and A a point of the axis that is y . ((P - A) x n) = 0, which is of the same form: a sin theta + b
/// cos theta = c. The locus is unrolled (roller.hpp), and again it is a curve against the profile of the
/// rail. At an edge (a convex kink of the profile) the normal turns while s stays.
///
/// Of an uneven wheel or rail the locus has the point of each circle that comes nearest to the straightened
/// rail (NearestAlong). Its x and its curvature along x are those of a round wheel, and what the stretch that
/// is nearly as near has more than that of a round wheel.
class ContactLocus {
public:
  explicit ContactLocus(const WheelOnRail& pair);

  struct Point {
    double s = 0;          ///< arc length on the wheel's profile, mm
    double x = 0;          ///< mm
    Point2 position;       ///< (y, z), mm
    double rail_lower = 0; ///< how much lower than a straight rail an uneven one is under it, mm
    double ahead = 0;      ///< of where a round wheel would be nearest to a straight rail, mm
    double sharper = 1;    ///< curvature along x in that of a round wheel on a straight rail
  };
  /// Nodes lie in walking order, from the field side to the flange, at most 0.1 mm of s apart. A node that
  /// begins a stretch of its own has `joined` false.
  struct Node : Point {
    Point2 tangent;     ///< of the profile, in its section
    bool joined = true; ///< to the node before it
    int interval = 0;   ///< which interval of the tabulated profile begins at this node
  };
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Between nodes k and k + 1, 0 <= t <= 1 (joined ones).
  Point between(int k, double t) const;
  /// Curvature of the wheel along x there, positive where it is convex (1 / radius on the tread), with that
  /// of a roller, 1/mm; of an uneven one as if it was round (Point::sharper).
  double curvature_along_x(int k, double t) const;
  /// At an arc length of the wheel's profile, with the inclination of the surface in the track frame (near pi
  /// on the tread) and the curvature of the profile; nothing where there is no locus.
  std::optional<CurvePoint> at(double s) const;

  const WheelFrame& frame() const { return frame_; }
  void lower(double by); ///< with the wheel, along the track's z, mm

private:
  /// Where on its circle a point of the profile has the normal that the rail can meet.
  struct Meridian {
    double sine = 0, cosine = 1; ///< of theta
    std::optional<NearestAlong::Place> uneven = {};
  };
  std::optional<Meridian> meridian(double s, Point2 position, Point2 tangent) const;
  std::optional<Meridian> even_meridian(Point2 position, Point2 tangent) const;
  Vector3 on_circle(double s, Point2 position, const Meridian& m) const; ///< that point, in space
  /// The wheel's normal at that place, as the half-plane of the roller sees it (a straight rail: the track).
  struct Surface {
    double along_profile = 0; ///< x component of the direction along the profile
    Vector3 normal{};
    double rail = 0; ///< curvature of the rail along x under it, 1/mm
  };
  Surface surface(double s, Point2 position, Point2 tangent, const Meridian& m) const;
  std::optional<Point> point(double s, Point2 position, Point2 tangent) const;
  void trace();

  TabulatedProfile wheel_;
  double radius_ = 0;
  WheelFrame frame_;
  Vector3 down_{0, 0, 1}; ///< the track's z
  std::optional<Roller> roller_;
  std::optional<NearestAlong> nearest_; ///< nothing: the wheel is round and the rail the same along x
  std::vector<Node> nodes_;
};

} // namespace bem_contact
