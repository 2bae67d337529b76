#include "bem_contact/profile/profile_curve.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/fnv1a.hpp"
#include "bem_contact/profile/spline.hpp"
#include "bem_contact/profile/turn_at.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact {

namespace {

using std::numbers::pi;

/// 1. A corner also turns by more than this many times the turns beside it. On a coarsely sampled arc all
/// turns are alike, so that it gets no corners.
constexpr double corner_contrast = 2.0;
/// mm. Nearer points of a curve coincide: a chord between them has no direction.
constexpr double coinciding_points = 1e-9;
/// mm. A point this near to y = 0 lies on it: the rounding of a joint's coordinates.
constexpr double on_axis = 1e-12;
/// 1. Bounds of a search for the nearest piece are widened by so much, so that no piece's own bound, rounded,
/// excludes it.
constexpr double bound_rounding = 1e-12;

double to_branch(double angle, double near) {
  return angle + 2 * pi * std::round((near - angle) / (2 * pi));
}

void translate(CurvePiece& piece, Point2 by) {
  piece.start = piece.start + by;
  piece.middle = piece.middle + by;
  piece.y[0] += by.y;
  piece.z[0] += by.z;
}

/// Arc length from the curve's start to its first crossing of y = 0; 0 where there is none.
double length_to_axis(const std::vector<CurvePiece>& pieces) {
  for (const CurvePiece& piece : pieces) {
    const auto y_at = [&](double along) { return point_on(piece, along).position.y; };
    if (std::abs(y_at(0)) < on_axis)
      return piece.s0;
    if (std::abs(y_at(piece.length)) < on_axis)
      return piece.s0 + piece.length;
    if (y_at(0) * y_at(piece.length) > 0)
      continue;
    const auto [low, high] = boost::math::tools::bisect(
        y_at, 0.0, piece.length, [&](double a, double b) { return b - a <= axis_tolerance * piece.length; });
    return piece.s0 + (low + high) / 2;
  }
  return 0;
}

} // namespace

ProfileCurve ProfileCurve::from_pieces(std::string name, std::vector<CurvePiece> pieces) {
  if (pieces.empty())
    throw InputError(fmt::format("Profile '{}' is empty", name), "a curve needs at least one piece",
                     "Give its pieces.");
  // The chord tells which way the curve is walked, hence the branch of delta: near 0 on a rail, near pi on
  // a wheel.
  const CurvePiece& last = pieces.back();
  const Point2 chord = point_on(last, last.length).position - pieces.front().start;
  double branch = std::atan2(chord.z, chord.y);
  if (branch <= -pi / 2)
    branch += 2 * pi;
  Point2 end = pieces.front().start;
  double s = 0;
  for (CurvePiece& piece : pieces) {
    translate(piece, end - piece.start);
    piece.delta0 = to_branch(piece.delta0, branch);
    piece.s0 = s;
    const PiecePoint far = point_on(piece, piece.length);
    end = far.position;
    branch = far.delta;
    s += piece.length;
  }
  ProfileCurve curve;
  curve.name_ = std::move(name);
  const double origin = length_to_axis(pieces);
  for (CurvePiece& piece : pieces)
    piece.s0 -= origin;
  curve.s_begin_ = -origin;
  curve.s_end_ = s - origin;
  curve.pieces_ = std::move(pieces);
  return curve;
}

ProfileCurve ProfileCurve::through_points(std::string name, std::span<const Point2> points,
                                          double corner_turn) {
  std::vector<std::size_t> corners;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double turn = turn_at(points, i);
    if (turn > corner_turn && turn > corner_contrast * turn_at(points, i - 1) &&
        turn > corner_contrast * turn_at(points, i + 1))
      corners.push_back(i);
  }
  return through_points(std::move(name), points, corners);
}

ProfileCurve ProfileCurve::through_points(std::string name, std::span<const Point2> points,
                                          std::span<const std::size_t> corners) {
  if (points.size() < 3)
    throw InputError(fmt::format("Profile '{}' has {}", name, counted(points.size(), "point", "points")),
                     "a curve needs at least 3", "Give more points.");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(std::isfinite(points[i].y) && std::isfinite(points[i].z)))
      throw InputError(fmt::format("Point {} of profile '{}' is not a number", i + 1, name),
                       "coordinates must be finite", "Remove or mend the point.");
    if (i > 0 && norm(points[i] - points[i - 1]) < coinciding_points)
      throw InputError(fmt::format("Points {} and {} of profile '{}' coincide", i, i + 1, name),
                       "a curve has no direction there", "Remove one of them.");
  }
  std::vector<CurvePiece> pieces;
  std::size_t begin = 0;
  for (const std::size_t corner : corners) {
    append_spline(pieces, points.subspan(begin, corner + 1 - begin));
    begin = corner;
  }
  append_spline(pieces, points.subspan(begin));
  return from_pieces(std::move(name), std::move(pieces));
}

std::vector<double> ProfileCurve::joints() const {
  std::vector<double> s;
  for (const CurvePiece& piece : pieces_)
    s.push_back(piece.s0);
  s.push_back(s_end_);
  return s;
}

const CurvePiece& ProfileCurve::piece_at(double s) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                      [](double value, const CurvePiece& piece) { return value < piece.s0; });
  return after == pieces_.begin() ? pieces_.front() : *(after - 1);
}

CurvePoint ProfileCurve::at(double s) const {
  if (!(s >= s_begin_ - end_slack && s <= s_end_ + end_slack))
    throw InputError(fmt::format("Arc length s = {} mm is off the profile '{}'", s, name_),
                     fmt::format("the profile runs from {:.6g} to {:.6g} mm", s_begin_, s_end_),
                     "Ask for a point on the profile.");
  s = std::clamp(s, s_begin_, s_end_);
  const CurvePiece& piece = piece_at(s);
  const PiecePoint p = point_on(piece, s - piece.s0);
  return {s, p.position, p.delta, p.curvature};
}

CurvePoint ProfileCurve::nearest(Point2 p) const {
  if (!(std::isfinite(p.y) && std::isfinite(p.z)))
    throw InputError(fmt::format("No point of the profile '{}' is nearest to ({}, {})", name_, p.y, p.z),
                     "coordinates must be finite", "Check where they come from.");
  // |p - middle| bounds the distance to a piece from above, |p - middle| - length/2 from below.
  const auto squared = [&](const CurvePiece& piece) { return dot(p - piece.middle, p - piece.middle); };
  double bound = std::numeric_limits<double>::infinity();
  for (const CurvePiece& piece : pieces_)
    bound = std::min(bound, squared(piece));
  bound = std::sqrt(bound);
  const CurvePiece* best = nullptr;
  double best_along = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const CurvePiece& piece : pieces_) {
    const double farthest = std::min(bound, least) + piece.length / 2;
    if (squared(piece) > farthest * farthest * (1 + bound_rounding))
      continue;
    const double along = nearest_on(piece, p);
    const double distance = norm(p - point_on(piece, along).position);
    if (distance < least) {
      least = distance;
      best = &piece;
      best_along = along;
    }
  }
  const PiecePoint point = point_on(*best, best_along);
  return {best->s0 + best_along, point.position, point.delta, point.curvature};
}

std::uint64_t ProfileCurve::digest() const {
  Fnv1a hash;
  const auto add = [&hash](double value) {
    auto bits = static_cast<std::uint64_t>(std::llround(value * 1e6));
    std::array<std::byte, 8> bytes; // little-endian on any machine
    for (std::byte& b : bytes) {
      b = static_cast<std::byte>(bits & 0xff);
      bits >>= 8;
    }
    hash.add(bytes);
  };
  constexpr int steps = 256;
  for (int i = 0; i <= steps; ++i) {
    const Point2 p = at(s_begin_ + (s_end_ - s_begin_) * i / steps).position;
    add(p.y);
    add(p.z);
  }
  return hash.value();
}

std::vector<CurvePoint> points_along(const ProfileCurve& curve, double step) {
  const double length = curve.s_end() - curve.s_begin();
  const int steps = std::max(1, static_cast<int>(std::ceil(length / step)));
  std::vector<CurvePoint> out;
  for (int i = 0; i <= steps; ++i)
    out.push_back(curve.at(curve.s_begin() + length * i / steps));
  return out;
}

} // namespace bem_contact
