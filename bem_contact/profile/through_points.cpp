#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <fmt/format.h>

#include <cmath>

namespace bem_contact {

namespace {

/// Angle by which the chords turn at point i, 0 at the ends.
double turn_at(std::span<const Point2> p, std::size_t i) {
  if (i == 0 || i + 1 >= p.size())
    return 0;
  const Point2 a = p[i] - p[i - 1], b = p[i + 1] - p[i];
  return std::abs(std::atan2(a.y * b.z - a.z * b.y, dot(a, b)));
}

/// Second derivatives of the cubic spline through (t, v), third derivative continuous at the points next
/// to the ends (not-a-knot; de Boor, A practical guide to splines, 1978, ch. IV).
std::vector<double> second_derivatives(std::span<const double> t, std::span<const double> v) {
  const std::size_t n = t.size();
  std::vector<double> m(n, 0.0);
  if (n < 3)
    return m;
  const auto h = [&](std::size_t i) { return t[i + 1] - t[i]; };
  const auto slope = [&](std::size_t i) { return (v[i + 1] - v[i]) / h(i); };
  if (n == 3) { // the parabola
    m.assign(3, 2 * (slope(1) - slope(0)) / (h(0) + h(1)));
    return m;
  }
  // Unknowns m[1] .. m[n-2]; m[0] and m[n-1] eliminated by m0 = m1 + (m1 - m2) h0/h1 and its mirror image.
  std::vector<double> lower(n), diagonal(n), upper(n), right(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    lower[i] = h(i - 1);
    diagonal[i] = 2 * (h(i - 1) + h(i));
    upper[i] = h(i);
    right[i] = 6 * (slope(i) - slope(i - 1));
  }
  const double first = h(0) / h(1), last = h(n - 2) / h(n - 3);
  diagonal[1] += h(0) * (1 + first);
  upper[1] -= h(0) * first;
  diagonal[n - 2] += h(n - 2) * (1 + last);
  lower[n - 2] -= h(n - 2) * last;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const double factor = lower[i] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  m[n - 2] = right[n - 2] / diagonal[n - 2];
  for (std::size_t i = n - 2; i-- > 1;)
    m[i] = (right[i] - upper[i] * m[i + 1]) / diagonal[i];
  m[0] = m[1] + (m[1] - m[2]) * first;
  m[n - 1] = m[n - 2] + (m[n - 2] - m[n - 3]) * last;
  return m;
}

void add_spline(std::vector<CurvePiece>& pieces, std::span<const Point2> p) {
  const std::size_t n = p.size();
  std::vector<double> t(n, 0.0), y(n), z(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0)
      t[i] = t[i - 1] + norm(p[i] - p[i - 1]);
    y[i] = p[i].y;
    z[i] = p[i].z;
  }
  const std::vector<double> my = second_derivatives(t, y), mz = second_derivatives(t, z);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double h = t[i + 1] - t[i];
    const auto cubic = [&](const std::vector<double>& v, const std::vector<double>& m) {
      return std::array<double, 4>{v[i], (v[i + 1] - v[i]) / h - h * (2 * m[i] + m[i + 1]) / 6, m[i] / 2,
                                   (m[i + 1] - m[i]) / (6 * h)};
    };
    pieces.push_back(polynomial_piece(cubic(y, my), cubic(z, mz), h));
  }
}

} // namespace

ProfileCurve ProfileCurve::through_points(std::string name, std::span<const Point2> points,
                                          double kink_angle) {
  if (points.size() < 3)
    throw InputError(fmt::format("profile '{}' has {} points", name, points.size()),
                     "a curve needs at least 3", "Give more points.");
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(std::isfinite(points[i].y) && std::isfinite(points[i].z)))
      throw InputError(fmt::format("point {} of profile '{}' is not a number", i + 1, name),
                       "coordinates must be finite", "Remove or mend the point.");
    if (i > 0 && norm(points[i] - points[i - 1]) < 1e-9)
      throw InputError(fmt::format("points {} and {} of profile '{}' coincide", i, i + 1, name),
                       "a curve has no direction there", "Remove one of them.");
  }
  std::vector<CurvePiece> pieces;
  std::size_t begin = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double turn = turn_at(points, i);
    const bool corner =
        turn > kink_angle && turn > 2 * turn_at(points, i - 1) && turn > 2 * turn_at(points, i + 1);
    if (corner || i + 1 == points.size()) {
      add_spline(pieces, points.subspan(begin, i + 1 - begin));
      begin = i;
    }
  }
  return from_pieces(std::move(name), std::move(pieces));
}

} // namespace bem_contact
