#include "bem_contact/halfspace/rectangle.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/kernels.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace bem_contact::halfspace {
namespace {

/// asinh(Y / |X|), 0 at X = 0: it is always multiplied by a power of X.
Real asinh_term(Real x, Real y) {
  return x == 0 ? Real(0) : std::asinh(y / std::abs(x));
}
/// atan(Y / X), 0 at X = 0: it is always multiplied by a power of X.
Real atan_term(Real x, Real y) {
  return x == 0 ? Real(0) : std::atan(y / x);
}
Real log_r2(Real x, Real y) {
  return x == 0 && y == 0 ? Real(0) : std::log(x * x + y * y);
}

// Antiderivatives once in X and once in Y (Love 1929; Kalker 1990, appendix E).
struct Second {
  static Real xx_r3(Real x, Real y) { return y * asinh_term(y, x); }
  static Real xs_r3(Real x, Real y) { return -std::hypot(x, y); }
  static Real x_r2(Real x, Real y) { return y / 2 * log_r2(x, y) + x * atan_term(x, y); }
};

// Antiderivatives twice in X and twice in Y; polynomials that the second differences annihilate are left
// out. All are continuous over both axes, so sums over corners hold for rectangles that straddle them.
struct Fourth {
  static Real xx_r3(Real x, Real y) {
    const Real r = std::hypot(x, y);
    return x * y * y / 2 * asinh_term(y, x) + x * x * r / 2 - r * r * r / 3;
  }
  static Real xs_r3(Real x, Real y) {
    const Real r = std::hypot(x, y);
    return -(x * y * r / 3 + x * x * x / 6 * asinh_term(x, y) + y * y * y / 6 * asinh_term(y, x));
  }
  static Real x_r2(Real x, Real y) {
    return x * (3 * y * y - x * x) / 12 * log_r2(x, y) + y * y * y / 6 * atan_term(y, x) +
           x * x * y / 2 * atan_term(x, y);
  }
};

/// Sum of weight_x[p] weight_y[q] F(x + p-th step, y + q-th step) for the five kernels, in extended
/// precision.
template <class Antiderivative, std::size_t N>
Kernels difference(Real x, Real y, const std::array<Real, N>& step_x, const std::array<Real, N>& step_y,
                   const std::array<Real, N>& weight) {
  std::array<Real, 5> sum{};
  for (std::size_t p = 0; p < N; ++p)
    for (std::size_t q = 0; q < N; ++q) {
      const Real px = x + step_x[p], py = y + step_y[q], w = weight[p] * weight[q];
      sum[0] += w * Antiderivative::xx_r3(px, py);
      sum[1] += w * Antiderivative::xx_r3(py, px);
      sum[2] += w * Antiderivative::xs_r3(px, py);
      sum[3] += w * Antiderivative::x_r2(px, py);
      sum[4] += w * Antiderivative::x_r2(py, px);
    }
  Kernels k;
  k.xx_r3 = static_cast<double>(sum[0]);
  k.ss_r3 = static_cast<double>(sum[1]);
  k.xs_r3 = static_cast<double>(sum[2]);
  k.x_r2 = static_cast<double>(sum[3]);
  k.s_r2 = static_cast<double>(sum[4]);
  return k;
}

Kernels point_kernels(double x, double y) {
  const double r2 = x * x + y * y, r3 = r2 * std::sqrt(r2);
  return {x * x / r3, y * y / r3, x * y / r3, x / r2, y / r2};
}

/// The relative position of a load element and its equal receiver along one axis has a triangular density on
/// (-2a, 2a): Gauss on each half, total weight 2a (length of the load, mean over the receiver).
template <std::size_t N> struct Hat {
  std::array<double, 2 * N> point, weight;
  Hat(double a, const std::array<double, N>& gauss_point, const std::array<double, N>& gauss_weight) {
    for (std::size_t g = 0; g < N; ++g) {
      const double t = (1 + gauss_point[g]) / 2;
      point[g] = 2 * a * t;
      point[g + N] = -2 * a * t;
      weight[g] = weight[g + N] = a * gauss_weight[g] * (1 - t);
    }
  }
};

template <std::size_t N> Kernels quadrature(double x, double y, const Hat<N>& hat_x, const Hat<N>& hat_y) {
  Kernels sum;
  for (std::size_t p = 0; p < 2 * N; ++p)
    for (std::size_t q = 0; q < 2 * N; ++q)
      sum.add(hat_x.weight[p] * hat_y.weight[q], point_kernels(x + hat_x.point[p], y + hat_y.point[q]));
  return sum;
}

/// Closed form near the load, where the kernel is singular; quadrature far from it, where second
/// differences of terms growing like r^3 would cancel. Gauss with N points on a half of the density is exact
/// to (2 r / a)^(-2N): 1e-14 at each switch.
Kernels average_kernels(double x, double y, double a, double b) {
  const double distance = std::hypot(x, y) / std::max(a, b);
  if (distance < 12) {
    const Real ra = 2 * Real(a), rb = 2 * Real(b);
    const Kernels sum = difference<Fourth, 3>(x, y, {-ra, 0, ra}, {-rb, 0, rb}, {1, -2, 1});
    return Kernels{}.add(1 / (4 * a * b), sum);
  }
  if (distance < 120)
    return quadrature<6>(x, y, {a, gauss<6>.point, gauss<6>.weight}, {b, gauss<6>.point, gauss<6>.weight});
  return quadrature<3>(x, y, {a, gauss<3>.point, gauss<3>.weight}, {b, gauss<3>.point, gauss<3>.weight});
}

/// Kernels at (|x|, |s|) with the signs put back, so that parity is exact.
template <class Function> Kernels by_parity(double x, double s, Function&& function) {
  Kernels k = function(std::abs(x), std::abs(s));
  k.x_r2 = x == 0 ? 0 : std::copysign(k.x_r2, x);
  k.s_r2 = s == 0 ? 0 : std::copysign(k.s_r2, s);
  k.xs_r3 = x == 0 || s == 0 ? 0 : std::copysign(k.xs_r3, x) * (s < 0 ? -1 : 1);
  return k;
}

} // namespace

Matrix3 assemble(const Material& material, const Kernels& k) {
  const double nu = material.poisson;
  const double c = 1 / (2 * std::numbers::pi * material.shear_modulus);
  const double inverse_r = k.xx_r3 + k.ss_r3;
  const double coupling = (1 - 2 * nu) / 2;
  Matrix3 m{};
  m[component_x][component_x] = c * ((1 - nu) * inverse_r + nu * k.xx_r3);
  m[component_s][component_s] = c * ((1 - nu) * inverse_r + nu * k.ss_r3);
  m[component_n][component_n] = c * (1 - nu) * inverse_r;
  m[component_x][component_s] = m[component_s][component_x] = c * nu * k.xs_r3;
  m[component_x][component_n] = -c * coupling * k.x_r2;
  m[component_n][component_x] = c * coupling * k.x_r2;
  m[component_s][component_n] = -c * coupling * k.s_r2;
  m[component_n][component_s] = c * coupling * k.s_r2;
  return m;
}

void require_size(double value, const char* name) {
  constexpr double least = 1e-30, most = 1e30; // their cubes and ratios stay numbers
  if (!(value >= least && value <= most))
    throw InputError(std::string("the element's ") + name + " is not a positive number",
                     value > 0 ? "it lies outside 1e-30 .. 1e30 mm" : std::to_string(value) + " mm",
                     "give a positive length in mm");
}

Matrix3 at_point(const Material& material, double x, double s, double a, double b) {
  require_size(2 * a, "length 2a");
  require_size(2 * b, "width 2b");
  return assemble(material, by_parity(x, s, [&](double px, double ps) {
                    // The load's element covers (-a, a) x (-b, b): the kernel is integrated over x - xi, s -
                    // eta.
                    return difference<Second, 2>(px, ps, {-Real(a), Real(a)}, {-Real(b), Real(b)}, {-1, 1});
                  }));
}

Matrix3 averaged(const Material& material, double x, double s, double a, double b) {
  require_size(2 * a, "length 2a");
  require_size(2 * b, "width 2b");
  return assemble(material,
                  by_parity(x, s, [&](double px, double ps) { return average_kernels(px, ps, a, b); }));
}

InfluenceNumbers numbers(const Material& material, double dx, double ds, int offsets, int rows) {
  require_size(dx, "length dx");
  require_size(ds, "width ds");
  if (offsets < 1 || rows < 1)
    throw InputError("an influence table without elements was asked for",
                     std::to_string(offsets) + " offsets, " + std::to_string(rows) + " rows",
                     "ask for at least one of each");
  InfluenceNumbers result{offsets, rows, dx, ds, {}, true};
  result.values.resize(result.expected_values());
  std::vector<Matrix3> line(static_cast<std::size_t>(offsets));
  for (int d = 0; d < rows; ++d) {
    averaged_line(material, d * ds, dx, ds, line);
    for (int m = 0; m < offsets; ++m)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double value = line[static_cast<std::size_t>(m)][i][j];
          result.at(m, d, i, 0, j) = value;
          result.at(m, 0, j, d, i) = parity(i, j) * value;
        }
  }
  return result;
}

Matrix3 averaged_plane_strain(const Material& material, double s, double ds, double reference_distance) {
  require_size(ds, "width ds");
  require_size(reference_distance, "reference distance");
  // Double integrals over load and receiver, divided by the receiver's width. Of ln|s| the second
  // antiderivative is s^2/2 ln|s| - 3/4 s^2; of sign(s) it is s|s|/2.
  const auto second_difference = [&](auto&& f) {
    const Real at = std::abs(s), h = ds;
    return static_cast<double>((f(at - h) - 2 * f(at) + f(at + h)) / h);
  };
  const double log_mean = second_difference([&](Real t) {
    return t == 0 ? Real(0) : t * t / 2 * std::log(std::abs(t) / Real(reference_distance)) - t * t * 3 / 4;
  });
  const double sign_mean =
      s == 0 ? 0 : std::copysign(second_difference([](Real t) { return t * std::abs(t) / 2; }), s);
  const double nu = material.poisson;
  const double c = 1 / (std::numbers::pi * material.shear_modulus);
  const double coupling = (1 - 2 * nu) / (4 * material.shear_modulus) * sign_mean;
  Matrix3 m{};
  m[component_x][component_x] = -c * log_mean;
  m[component_s][component_s] = m[component_n][component_n] = -c * (1 - nu) * log_mean;
  m[component_s][component_n] = -coupling;
  m[component_n][component_s] = coupling;
  return m;
}

InfluenceNumbers plane_strain_numbers(const Material& material, double ds, int rows,
                                      double reference_distance) {
  if (rows < 1)
    throw InputError("an influence table without elements was asked for", std::to_string(rows) + " rows",
                     "ask for at least one row");
  InfluenceNumbers result{1, rows, 0, ds, {}};
  result.values.resize(9 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows));
  for (int d = 1 - rows; d < rows; ++d) {
    const Matrix3 m = averaged_plane_strain(material, d * ds, ds, reference_distance);
    for (int row = std::max(0, -d); row < rows && row + d < rows; ++row)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result.at(0, row + d, i, row, j) = m[i][j];
  }
  return result;
}

} // namespace bem_contact::halfspace
