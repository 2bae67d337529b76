#include "bem_contact/profile/movable_points.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// mm. So little before a joint the piece that ends there has its inclination at the joint.
constexpr double just_before = 1e-7;
/// rad. A smaller turn over just_before is curvature. Chosen.
constexpr double least_corner = 1e-5;
/// mm. Two curves nearer than that are one. Chosen: rounding is far below, and other curves are far above.
constexpr double same_curve = 1e-7;
/// Places at which they are compared.
constexpr int compared_places = 256;

std::vector<Point2> positions(const std::vector<CurvePoint>& points) {
  std::vector<Point2> out;
  for (const CurvePoint& p : points)
    out.push_back(p.position);
  return out;
}

bool same(const ProfileCurve& a, const ProfileCurve& b) {
  const double length = a.s_end() - a.s_begin();
  if (std::abs(b.s_end() - b.s_begin() - length) > same_curve)
    return false;
  for (int k = 0; k <= compared_places; ++k) {
    const double along = length * k / compared_places;
    if (norm(a.at(a.s_begin() + along).position - b.at(std::min(b.s_begin() + along, b.s_end())).position) >
        same_curve)
      return false;
  }
  return true;
}

} // namespace

MovablePoints::MovablePoints(const ProfileCurve& curve) : name_(curve.name()) {
  for (const double s : curve.joints()) {
    points_.push_back(curve.at(s));
    before_.push_back(curve.at(std::max(s - just_before, curve.s_begin())).delta);
    if (const std::size_t k = points_.size() - 1;
        k > 0 && s < curve.s_end() && std::abs(points_[k].delta - before_[k]) > least_corner)
      corners_.push_back(k);
  }
  const bool enough = points_.size() > 2;
  if (!enough || !same(curve, ProfileCurve::through_points(name_, positions(points_), corners_)))
    throw InputError(fmt::format("The profile '{}' has no points to move", name_),
                     "it is made of arcs and polynomials, not of a curve through points",
                     "Write it as points (bem_contact profile), and name that file.");
}

Point2 MovablePoints::outwards(std::size_t point) const {
  const double delta = 0.5 * (points_[point].delta + before_[point]);
  return {std::sin(delta), -std::cos(delta)};
}

ProfileCurve MovablePoints::moved(std::size_t point, double distance) const {
  std::vector<Point2> all = positions(points_);
  all[point] = all[point] + distance * outwards(point);
  return ProfileCurve::through_points(name_, all, corners_);
}

} // namespace bem_contact
