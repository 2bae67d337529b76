#include "bem_contact/profile/worn/nominal_place.hpp"

#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/worn/settings.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

using Weight = std::function<double(double)>;

/// One Gauss-Newton step of weighted least squares over the distances. Returns how far it moves, mm.
double step(NominalPlace& place, const ProfileCurve& nominal, std::span<const Point2> points,
            const Weight& weight) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double total = 0;
  for (const Point2 p : points) {
    const PointOnNominal seen = seen_from(nominal, p, place);
    if (seen.beyond)
      continue;
    const Point2 q = place.to_nominal(p), n = seen.normal;
    const Eigen::Vector3d change(n.y, n.z, cross(q, n) / placing_arm);
    const double w = weight(seen.depth);
    matrix += w * change * change.transpose();
    right += w * seen.depth * change;
    total += w;
  }
  matrix.diagonal().array() += placing_damping * total + std::numeric_limits<double>::min();
  const Eigen::Vector3d move = matrix.ldlt().solve(right);
  place.shift = place.shift + turned({move[0], move[1]}, place.angle);
  place.angle += move[2] / placing_arm;
  return move.norm();
}

double median_distance(const ProfileCurve& nominal, std::span<const Point2> points,
                       const NominalPlace& place) {
  std::vector<double> distances;
  for (const Point2 p : points) {
    const Point2 q = place.to_nominal(p);
    distances.push_back(norm(q - nominal.nearest(q).position));
  }
  return median(std::move(distances));
}

/// By the least sum of distances (weights 1 / distance).
void lay(NominalPlace& place, const ProfileCurve& nominal, std::span<const Point2> points, double least) {
  const Weight weight = [&](double d) { return 1 / std::max(std::abs(d), least); };
  for (int i = 0; i < placing_steps; ++i)
    if (step(place, nominal, points, weight) < placing_tolerance)
      return;
}

/// By what lies on it.
void settle(NominalPlace& place, const ProfileCurve& nominal, std::span<const Point2> points, double least) {
  for (int i = 0; i < placing_steps; ++i) {
    const double width =
        std::max(tukey_width * normal_deviation_over_median * median_distance(nominal, points, place), least);
    const Weight weight = [&](double d) {
      const double root = 1 - d * d / (width * width);
      return root > 0 ? root * root : 0.0;
    };
    if (step(place, nominal, points, weight) < placing_tolerance)
      return;
  }
}

/// Middle, along y, and height of what is near the top of a rail, or near the tip of a wheel's flange.
Point2 top_of(std::span<const Point2> points, bool wheel) {
  const double top =
      wheel ? std::ranges::max(points, {}, &Point2::z).z : std::ranges::min(points, {}, &Point2::z).z;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point2 p : points)
    if (std::abs(p.z - top) < placing_top) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  return {(low + high) / 2, top};
}

/// Places from which the search begins, if the file's own frame is far from that of the nominal profile.
std::vector<NominalPlace> starts(const ProfileCurve& nominal, std::span<const Point2> points) {
  std::vector<Point2> its;
  for (int i = 0; i <= placing_points; ++i)
    its.push_back(
        nominal.at(nominal.s_begin() + (nominal.s_end() - nominal.s_begin()) * i / placing_points).position);
  const bool wheel = its.back().y < its.front().y;
  std::vector<NominalPlace> out;
  for (const double angle : placing_angles) {
    std::vector<Point2> turned_points;
    std::ranges::transform(points, std::back_inserter(turned_points),
                           [&](Point2 p) { return turned(p, -angle); });
    const Point2 shift = top_of(turned_points, wheel) - top_of(its, wheel);
    for (const double side : placing_sides)
      out.push_back({turned(shift + Point2{side, 0}, angle), angle});
  }
  return out;
}

} // namespace

PointOnNominal seen_from(const ProfileCurve& nominal, Point2 measured, const NominalPlace& place) {
  const Point2 q = place.to_nominal(measured);
  const CurvePoint foot = nominal.nearest(q);
  const Point2 normal = normal_of(foot.delta);
  const double along = dot(q - foot.position, tangent_of(foot.delta)); // 0 but at the ends
  return {foot.s, normal, dot(q - foot.position, normal), std::abs(along) > beyond_end};
}

NominalPlace place_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter) {
  std::vector<Point2> few;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / placing_points);
  for (std::size_t i = 0; i < points.size(); i += stride)
    few.push_back(points[i]);
  const double least = std::max(placing_scatters * scatter, least_placing_distance);
  NominalPlace best;
  lay(best, nominal, few, least);
  double distance = median_distance(nominal, few, best);
  if (distance > placed_distance)
    for (NominalPlace place : starts(nominal, few)) {
      lay(place, nominal, few, least);
      if (const double its = median_distance(nominal, few, place); its < distance) {
        best = place;
        distance = its;
      }
    }
  lay(best, nominal, points, least);
  settle(best, nominal, points, tukey_width * least);
  return best;
}

} // namespace bem_contact
