#pragma once

#include "bem_contact/geometry/roller.hpp"
#include "bem_contact/geometry/unevenness.hpp"

#include <vector>

namespace bem_contact {

/// Where on a circle of an uneven wheel it comes nearest to a rail that is uneven along x.
///
/// A point of the profile turns about the axle on a circle. On a round wheel above a straight rail the
/// nearest point of the circle is known (ContactLocus). Unevenness takes it somewhere else, and there may be
/// several such places, or a stretch: a flat that lies on the rail. So the circle is sampled as far as
/// unevenness can make it touch, and the best sample refined.
class NearestAlong {
public:
  NearestAlong(UnevenSurfaces surfaces, const WheelFrame& frame, double wheel_radius);

  /// The place, and the stretch in which the circle is nearly as near.
  struct Place {
    double theta = 0;   ///< angle on the wheel, as in UnevenSurfaces::wheel, rad
    double x = 0;       ///< middle of the stretch, from the wheelset's centre, mm
    double ahead = 0;   ///< of where a round wheel would be nearest to a straight rail, mm
    double sharper = 1; ///< curvature along x of a parabola as wide as the stretch, in that of a round wheel
    double rail_lower = 0; ///< how much lower than a straight rail the rail is at theta, mm
  };
  /// `section`: the point of the profile at arc length s; `normal`: outward, where even bodies would be
  /// nearest.
  Place at(double s, Point2 section, const Vector3& normal) const;

  const UnevenSurfaces& surfaces() const { return surfaces_; }

private:
  /// One circle, of the point of the profile at s, with the normal along which nearness is measured.
  struct Circle {
    double s, radius, x0, n_down, n_forward, n_axle, n_z, n_radial;
  };
  /// An angle on the wheel, and how much nearer to the axle all of the profile is there.
  struct Sample {
    double theta, sine, cosine, depth;
  };
  Sample sample(double theta) const;
  Point2 offset(const Circle& c, const Sample& s) const;
  double x_of(const Circle& c, const Sample& s) const;
  double reach(const Circle& c, const Sample& s) const;
  double end_of_stretch(const Circle& c, int inside, int outside, double least) const;

  UnevenSurfaces surfaces_;
  WheelFrame frame_;
  double radius_ = 0;
  std::vector<Sample> samples_;
  int beside_ = 0; ///< so many samples on either side of where an even circle is nearest are looked at
};

} // namespace bem_contact
