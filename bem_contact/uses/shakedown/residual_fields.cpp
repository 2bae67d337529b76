#include "bem_contact/uses/shakedown/residual_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace bem_contact::shakedown {

namespace {

/// 1. Degrees of the splines of Airy's function and of Prandtl's: the least with continuous stresses of the
/// first and with stresses without jumps of the second.
constexpr int airy_degree = 3, prandtl_degree = 2;

/// The splines that are not zero at a point, with two derivatives; those at the ends, whose value or slope
/// does not vanish there, are left out.
struct SplinesAtPoint {
  int first = 0; ///< number of the first one; below 0 or above the last: left out
  std::vector<std::array<double, 3>> values;
};

int count_of(const std::vector<double>& knots, int degree) {
  return static_cast<int>(knots.size()) - 1 + degree - 2 * (degree - 1);
}

/// By the recursion of Cox and de Boor; derivatives from splines of lower degree.
SplinesAtPoint splines_at(const std::vector<double>& knots, int degree, double at) {
  const int intervals = static_cast<int>(knots.size()) - 1;
  const auto knot = [&](int i) { return knots[std::clamp(i, 0, intervals)]; };
  const int last = static_cast<int>(std::ranges::upper_bound(knots, at) - knots.begin()) - 1;
  const int k = std::clamp(last, 0, intervals - 1);
  // b[d][j]: spline of degree d that begins at knot k - d + j
  std::array<std::array<double, 4>, 4> b{};
  b[0][0] = 1;
  for (int d = 1; d <= degree; ++d)
    for (int j = 0; j <= d; ++j) {
      const int i = k - d + j;
      const double left = j > 0 ? b[d - 1][j - 1] : 0, right = j < d ? b[d - 1][j] : 0;
      const double wide = knot(i + d) - knot(i), next = knot(i + d + 1) - knot(i + 1);
      b[d][j] = (wide > 0 ? (at - knot(i)) / wide * left : 0) +
                (next > 0 ? (knot(i + d + 1) - at) / next * right : 0);
    }
  const auto value = [&](int d, int j) { return j >= 0 && j <= d ? b[d][j] : 0.0; };
  // derivative of the spline j of degree d, as a combination of those of one degree less
  const auto slope = [&](int d, int j, auto&& lower) {
    const int i = k - d + j;
    const double wide = knot(i + d) - knot(i), next = knot(i + d + 1) - knot(i + 1);
    return d * ((wide > 0 ? lower(d - 1, j - 1) / wide : 0) - (next > 0 ? lower(d - 1, j) / next : 0));
  };
  SplinesAtPoint out{k - (degree - 1), {}};
  for (int j = 0; j <= degree; ++j) {
    const double first = slope(degree, j, value);
    const double second =
        slope(degree, j, [&](int d, int l) { return l >= 0 && l <= d ? slope(d, l, value) : 0.0; });
    out.values.push_back({value(degree, j), first, second});
  }
  return out;
}

/// Adds the products of two splines: `stress` makes a deviator of their values.
template <class Stress>
void add_products(const SplinesAtPoint& s, int s_count, const SplinesAtPoint& n, int n_count, int from,
                  FieldsAtPoint& out, const Stress& stress) {
  for (std::size_t i = 0; i < s.values.size(); ++i)
    for (std::size_t j = 0; j < n.values.size(); ++j) {
      const int a = s.first + static_cast<int>(i), b = n.first + static_cast<int>(j);
      if (a < 0 || a >= s_count || b < 0 || b >= n_count)
        continue;
      out.fields.push_back(from + a * n_count + b);
      out.stress.push_back(stress(s.values[i], n.values[j]));
    }
}

} // namespace

ResidualFields::ResidualFields(std::vector<double> s_knots, std::vector<double> depth_knots, Residual kind,
                               double curvature)
    : s_knots_(std::move(s_knots)), depth_knots_(std::move(depth_knots)), kind_(kind), curvature_(curvature) {
}

int ResidualFields::size() const {
  const int airy = count_of(s_knots_, airy_degree) * count_of(depth_knots_, airy_degree);
  return airy + (kind_ == Residual::all
                     ? count_of(s_knots_, prandtl_degree) * count_of(depth_knots_, prandtl_degree)
                     : 0);
}

FieldsAtPoint ResidualFields::at(double s, double depth) const {
  FieldsAtPoint out;
  if (s <= s_knots_.front() || s >= s_knots_.back() || depth < depth_knots_.front() ||
      depth >= depth_knots_.back())
    return out;
  const double c = curvature_, h = 1 - c * depth;
  const int airy_s = count_of(s_knots_, airy_degree), airy_n = count_of(depth_knots_, airy_degree);
  add_products(splines_at(s_knots_, airy_degree, s), airy_s, splines_at(depth_knots_, airy_degree, depth),
               airy_n, 0, out, [c, h](const auto& f, const auto& g) {
                 return deviator({.ss = f[0] * g[2],
                                  .nn = f[2] * g[0] / (h * h) - c / h * f[0] * g[1],
                                  .sn = -f[1] * (g[1] / h + c / (h * h) * g[0])});
               });
  if (kind_ == Residual::all)
    add_products(splines_at(s_knots_, prandtl_degree, s), count_of(s_knots_, prandtl_degree),
                 splines_at(depth_knots_, prandtl_degree, depth), count_of(depth_knots_, prandtl_degree),
                 airy_s * airy_n, out, [h](const auto& f, const auto& g) {
                   return deviator({.xs = f[0] * g[1], .xn = -f[1] * g[0] / h});
                 });
  return out;
}

} // namespace bem_contact::shakedown
