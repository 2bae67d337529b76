#include "bem_contact/profile/curve_piece.hpp"

#include "bem_contact/profile/settings.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

namespace {

using std::numbers::pi;

/// 1. Samples of a polynomial piece from which the search for its nearest point starts. Pieces are about 1 mm
/// long, so that the distance has no second minimum between two samples. Chosen.
constexpr int nearest_samples = 6;
/// 1. Newton steps inside a polynomial piece: bounds. Newton converges in about four.
constexpr int arc_length_steps = 20;
/// 1. As above; each step may be a halving instead.
constexpr int nearest_steps = 60;

double sinc(double x) {
  return std::abs(x) < 1e-4 ? 1 - x * x / 6 : std::sin(x) / x;
}

struct Derivatives {
  Point2 value, first, second;
};

Derivatives evaluate(const CurvePiece& c, double t) {
  Derivatives d;
  for (int k = c.degree; k >= 0; --k) {
    d.second = t * d.second + 2 * d.first;
    d.first = t * d.first + d.value;
    d.value = t * d.value + Point2{c.y[k], c.z[k]};
  }
  return d;
}

double speed(const CurvePiece& c, double t) {
  Point2 first;
  for (int k = c.degree; k > 0; --k)
    first = t * first + k * Point2{c.y[k], c.z[k]};
  return std::sqrt(dot(first, first));
}

double arc_length(const CurvePiece& c, double t) {
  return boost::math::quadrature::gauss<double, 10>::integrate([&](double u) { return speed(c, u); }, 0.0, t);
}

double parameter_at(const CurvePiece& c, double along) {
  double t = c.t_end * along / c.length;
  for (int i = 0; i < arc_length_steps; ++i) {
    const double step = (arc_length(c, t) - along) / speed(c, t);
    t = std::clamp(t - step, 0.0, c.t_end);
    if (std::abs(step) <= parameter_tolerance * c.t_end)
      break;
  }
  return t;
}

PiecePoint polynomial_point(const CurvePiece& c, double t) {
  const Derivatives d = evaluate(c, t);
  const double v = norm(d.first);
  double delta = std::atan2(d.first.z, d.first.y);
  delta += 2 * pi * std::round((c.delta0 - delta) / (2 * pi));
  return {d.value, delta, cross(d.first, d.second) / (v * v * v)};
}

double nearest_on_arc(const CurvePiece& c, Point2 p) {
  if (c.curvature == 0)
    return std::clamp(dot(p - c.start, tangent_of(c.delta0)), 0.0, c.length);
  const double sign = c.curvature > 0 ? 1 : -1;
  const Point2 centre = c.start + (1 / c.curvature) * normal_of(c.delta0);
  const Point2 v = -sign * (p - centre);
  if (norm(v) == 0)
    return 0;
  double turn = sign * (std::atan2(-v.y, v.z) - c.delta0);
  const double whole = std::abs(c.curvature) * c.length;
  // Into the window of width 2 pi centred on the arc: beyond its ends the nearer end is nearest.
  turn -= 2 * pi * std::round((turn - whole / 2) / (2 * pi));
  return std::clamp(turn, 0.0, whole) / std::abs(c.curvature);
}

/// Least |c(t) - p| over the piece: the best of a few samples, then Newton held inside its neighbours.
double nearest_on_polynomial(const CurvePiece& c, Point2 p) {
  int best = 0;
  double least = 0;
  for (int i = 0; i <= nearest_samples; ++i) {
    const double distance = norm(evaluate(c, c.t_end * i / nearest_samples).value - p);
    if (i == 0 || distance < least) {
      least = distance;
      best = i;
    }
  }
  double low = c.t_end * std::max(best - 1, 0) / nearest_samples;
  double high = c.t_end * std::min(best + 1, nearest_samples) / nearest_samples;
  double t = c.t_end * best / nearest_samples;
  for (int i = 0; i < nearest_steps; ++i) {
    const Derivatives d = evaluate(c, t);
    const double slope = dot(d.value - p, d.first);
    (slope > 0 ? high : low) = t;
    const double bend = dot(d.first, d.first) + dot(d.value - p, d.second);
    double next = bend > 0 ? t - slope / bend : low - 1;
    if (!(next >= low && next <= high))
      next = (low + high) / 2;
    const bool done = std::abs(next - t) <= parameter_tolerance * c.t_end;
    t = next;
    if (done)
      break;
  }
  return arc_length(c, t);
}

} // namespace

CurvePiece line_piece(Point2 from, Point2 to) {
  return arc_piece(from, std::atan2(to.z - from.z, to.y - from.y), 0, norm(to - from));
}

CurvePiece arc_piece(Point2 from, Point2 to, double curvature) {
  const Point2 chord = to - from;
  const double half_turn = std::asin(std::clamp(norm(chord) * curvature / 2, -1.0, 1.0));
  const double length = curvature == 0 ? norm(chord) : 2 * half_turn / curvature;
  return arc_piece(from, std::atan2(chord.z, chord.y) - half_turn, curvature, length);
}

CurvePiece arc_piece(Point2 from, double delta, double curvature, double length) {
  CurvePiece piece;
  piece.length = length;
  piece.start = from;
  piece.delta0 = delta;
  piece.curvature = curvature;
  piece.middle = point_on(piece, length / 2).position;
  return piece;
}

CurvePiece polynomial_piece(std::span<const double> y, std::span<const double> z, double t_end) {
  CurvePiece piece;
  piece.kind = CurvePiece::Kind::polynomial;
  piece.t_end = t_end;
  piece.degree = static_cast<int>(std::max(y.size(), z.size())) - 1;
  std::copy(y.begin(), y.end(), piece.y.begin());
  std::copy(z.begin(), z.end(), piece.z.begin());
  piece.start = {y[0], z[0]};
  piece.length = arc_length(piece, t_end);
  const Point2 direction = evaluate(piece, 0).first;
  piece.delta0 = std::atan2(direction.z, direction.y);
  piece.middle = point_on(piece, piece.length / 2).position;
  return piece;
}

PiecePoint point_on(const CurvePiece& piece, double along) {
  along = std::clamp(along, 0.0, piece.length);
  if (piece.kind == CurvePiece::Kind::polynomial)
    return polynomial_point(piece, parameter_at(piece, along));
  const double half_turn = piece.curvature * along / 2;
  return {piece.start + along * sinc(half_turn) * tangent_of(piece.delta0 + half_turn),
          piece.delta0 + 2 * half_turn, piece.curvature};
}

double nearest_on(const CurvePiece& piece, Point2 p) {
  return piece.kind == CurvePiece::Kind::arc ? nearest_on_arc(piece, p) : nearest_on_polynomial(piece, p);
}

} // namespace bem_contact
