#include "bem_contact/profile/spline.hpp"

#include <array>

namespace bem_contact {

namespace {

/// Second derivatives ("moments") of the spline through (t, v).
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

} // namespace

void append_spline(std::vector<CurvePiece>& pieces, std::span<const Point2> p) {
  const std::size_t n = p.size();
  std::vector<double> t(n, 0.0), y(n), z(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0)
      t[i] = t[i - 1] + norm(p[i] - p[i - 1]);
    y[i] = p[i].y;
    z[i] = p[i].z;
  }
  const std::vector<double> moments_y = second_derivatives(t, y), moments_z = second_derivatives(t, z);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double h = t[i + 1] - t[i];
    const auto cubic = [&](const std::vector<double>& v, const std::vector<double>& m) {
      return std::array<double, 4>{v[i], (v[i + 1] - v[i]) / h - h * (2 * m[i] + m[i + 1]) / 6, m[i] / 2,
                                   (m[i + 1] - m[i]) / (6 * h)};
    };
    pieces.push_back(polynomial_piece(cubic(y, moments_y), cubic(z, moments_z), h));
  }
}

} // namespace bem_contact
