#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <cstddef>
#include <vector>

namespace bem_contact {

/// The points of a curve that is a spline through them (ProfileCurve::through_points): each can be moved.
class MovablePoints {
public:
  /// Throws InputError for any other curve, as that of a standard, which is made of arcs.
  explicit MovablePoints(const ProfileCurve& curve);

  /// In walking order; at a corner those of the piece that begins.
  const std::vector<CurvePoint>& points() const { return points_; }
  /// Unit vector out of the body; at a corner the mean of both sides.
  Point2 outwards(std::size_t point) const;
  /// The curve where one point is moved by so much out of the body along its normal, mm.
  ProfileCurve moved(std::size_t point, double distance) const;

private:
  std::string name_;
  std::vector<CurvePoint> points_;
  std::vector<double> before_; ///< inclination of the piece that ends there, rad
  std::vector<std::size_t> corners_;
};

} // namespace bem_contact
