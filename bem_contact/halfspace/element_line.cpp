#include "bem_contact/halfspace/element_line.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/halfspace/gauss.hpp"
#include "bem_contact/halfspace/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace bem_contact::halfspace {
namespace {

using Values = std::array<Real, 5>; ///< of the five kernels, in the order of Kernels

/// Antiderivatives twice in X and twice in Y of the five kernels; polynomials that the second differences
/// annihilate are left out (theory/numbers.md, section 2, has them one by one). They share their logarithms
/// and their arctangent here: with r = |(x, y)|, asinh(x/|y|) = sign(x) ln((|x| + r)/|y|).
Values antiderivatives(Real x, Real y) {
  const Real ax = std::abs(x), ay = std::abs(y), r = std::sqrt(x * x + y * y);
  if (r == 0)
    return {};
  const Real log_r = std::log(r);
  const Real asinh_xy = ay == 0 ? Real(0) : std::copysign(std::log((ax + r) / ay), x); // asinh(x/|y|)
  const Real asinh_yx = ax == 0 ? Real(0) : std::copysign(std::log((ay + r) / ax), y);
  Real atan_yx = 0, atan_xy = 0; // atan(y/x), atan(x/y)
  if (ax > 0 && ay > 0) {
    atan_yx = std::atan(y / x);
    atan_xy = std::copysign(std::numbers::pi_v<Real> / 2, atan_yx) - atan_yx;
  }
  const Real xx = x * x, yy = y * y, rrr = r * r * r / 3;
  return {x * yy / 2 * asinh_xy + xx * r / 2 - rrr, y * xx / 2 * asinh_yx + yy * r / 2 - rrr,
          -(x * y * r / 3 + xx * x / 6 * asinh_yx + yy * y / 6 * asinh_xy),
          x * (3 * yy - xx) / 6 * log_r + yy * y / 6 * atan_xy + xx * y / 2 * atan_yx,
          y * (3 * xx - yy) / 6 * log_r + xx * x / 6 * atan_yx + yy * x / 2 * atan_xy};
}

/// Second difference in s at x = column dx.
Values column_of_corners(int column, Real s, Real dx, Real ds) {
  const Real x = column * dx;
  const Values low = antiderivatives(x, s - ds), middle = antiderivatives(x, s),
               high = antiderivatives(x, s + ds);
  Values sum;
  for (std::size_t e = 0; e < 5; ++e)
    sum[e] = low[e] - 2 * middle[e] + high[e];
  return sum;
}

/// Elements first .. last of the line in closed form.
void closed_form(double s, double dx, double ds, int first, int last, std::span<Kernels> line) {
  Values left{}, here = column_of_corners(first - 1, s, dx, ds), right = column_of_corners(first, s, dx, ds);
  for (int m = first; m <= last; ++m) {
    left = here;
    here = right;
    right = column_of_corners(m + 1, s, dx, ds);
    const auto value = [&](std::size_t e) {
      return static_cast<double>((left[e] - 2 * here[e] + right[e]) / (Real(dx) * ds));
    };
    line[static_cast<std::size_t>(m)] = {value(0), value(1), value(2), value(3), value(4)};
  }
}

/// Adds w times the five kernels at the points (x, y) to `sums`: [kernel][point].
BEM_CONTACT_WIDE void add_kernels(const double* x, std::size_t points, double y, double w,
                                  double* __restrict sums) {
  double *const x2_r3 = sums, *const s2_r3 = x2_r3 + points, *const xs_r3 = s2_r3 + points;
  double *const x_r2 = xs_r3 + points, *const s_r2 = x_r2 + points;
  for (std::size_t p = 0; p < points; ++p) {
    const double inverse = 1 / (x[p] * x[p] + y * y), cube = w * inverse * std::sqrt(inverse);
    x2_r3[p] += x[p] * x[p] * cube;
    s2_r3[p] += y * y * cube;
    xs_r3[p] += y * x[p] * cube;
    x_r2[p] += w * x[p] * inverse;
    s_r2[p] += w * y * inverse;
  }
}

/// Elements first .. last by quadrature. The relative position of a load element and its equal receiver has a
/// triangular density of half width dx: N Gauss points in each cell between two centres serve the rising half
/// of one element and the falling half of the other.
template <std::size_t N>
void quadrature(double s, double dx, double ds, int first, int last, std::span<Kernels> line) {
  if (first > last)
    return;
  const auto cells =
      static_cast<std::size_t>(last - first + 2); // cell c: from centre first - 1 + c to the next
  const std::size_t points = N * cells;
  std::vector<double> x(points), sums(5 * points);
  std::array<double, N> t{}, half_weight{};
  for (std::size_t g = 0; g < N; ++g) {
    t[g] = 0.5 * (1 + gauss<N>().point[g]);
    half_weight[g] = 0.5 * gauss<N>().weight[g];
  }
  for (std::size_t p = 0; p < points; ++p)
    x[p] = dx * (first - 1 + static_cast<double>(p / N) + t[p % N]);
  for (std::size_t g = 0; g < N; ++g)
    for (const int side : {-1, 1})
      add_kernels(x.data(), points, s + side * ds * t[g], half_weight[g] * (1 - t[g]) * ds, sums.data());
  for (int m = first; m <= last; ++m) {
    const auto value = [&](std::size_t e) {
      const double* cell = &sums[e * points + N * static_cast<std::size_t>(m - first)];
      double rising = 0, falling = 0;
      for (std::size_t g = 0; g < N; ++g) {
        rising += half_weight[g] * t[g] * cell[g];
        falling += half_weight[g] * (1 - t[g]) * cell[N + g];
      }
      return dx * (rising + falling);
    };
    line[static_cast<std::size_t>(m)] = {value(0), value(1), value(2), value(3), value(4)};
  }
}

} // namespace

void averaged_line(const Material& material, double s, double dx, double ds, std::span<Matrix3> line) {
  require_size(dx, "length dx");
  require_size(ds, "width ds");
  const double distance = std::abs(s), unit = std::max(dx, ds) / 2;
  const auto count = static_cast<int>(line.size());
  /// First element at least `radius` half elements away.
  const auto from = [&](double radius) {
    const double left = radius * radius * unit * unit - distance * distance;
    return left <= 0 ? 0 : static_cast<int>(std::min(std::ceil(std::sqrt(left) / dx), double(count)));
  };
  std::vector<Kernels> kernels(line.size());
  const int near = from(closed_form_radius), middle = from(six_point_radius), far = from(four_point_radius);
  closed_form(distance, dx, ds, 0, near - 1, kernels);
  quadrature<6>(distance, dx, ds, near, middle - 1, kernels);
  quadrature<4>(distance, dx, ds, middle, far - 1, kernels);
  quadrature<3>(distance, dx, ds, far, count - 1, kernels);
  for (std::size_t m = 0; m < line.size(); ++m) {
    Kernels& k = kernels[m]; // the signs that parity asks for, exactly
    if (m == 0)
      k.x_r2 = k.xs_r3 = 0;
    if (s == 0)
      k.s_r2 = k.xs_r3 = 0;
    if (s < 0) {
      k.s_r2 = -k.s_r2;
      k.xs_r3 = -k.xs_r3;
    }
    line[m] = assemble(material, k);
  }
}

} // namespace bem_contact::halfspace
