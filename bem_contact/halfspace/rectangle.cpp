#include "bem_contact/halfspace/rectangle.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace bem_contact::halfspace {
namespace {

// The closed forms are differences of large numbers; extended precision keeps elements of a large aspect
// ratio exact where double would lose (r^2 / (4 a b))^2 digits.
using Real = long double;

/// The five basic kernels of Boussinesq-Cerruti, point-wise or integrated.
struct Kernels {
  double xx_r3 = 0; ///< x^2 / r^3
  double ss_r3 = 0; ///< s^2 / r^3
  double xs_r3 = 0; ///< x s / r^3
  double x_r2 = 0;  ///< x / r^2
  double s_r2 = 0;  ///< s / r^2

  Kernels& add(double weight, const Kernels& k) {
    xx_r3 += weight * k.xx_r3;
    ss_r3 += weight * k.ss_r3;
    xs_r3 += weight * k.xs_r3;
    x_r2 += weight * k.x_r2;
    s_r2 += weight * k.s_r2;
    return *this;
  }
};

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

// Gauss-Legendre on [-1, 1], six points.
constexpr std::array<double, 6> gauss_point = {-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                               0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
constexpr std::array<double, 6> gauss_weight = {0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                                0.4679139345726910, 0.3607615730481386, 0.1713244923791704};

/// The points and weights of a load element and its equal receiver along one axis: their relative position
/// has a triangular density on (-2a, 2a); Gauss on each half, total weight 2a (area of load, mean of
/// receiver).
struct Hat {
  std::array<double, 12> point, weight;
  explicit Hat(double a) {
    for (std::size_t g = 0; g < 6; ++g) {
      const double t = (1 + gauss_point[g]) / 2;
      point[g] = 2 * a * t;
      point[g + 6] = -2 * a * t;
      weight[g] = weight[g + 6] = a * gauss_weight[g] * (1 - t);
    }
  }
};

/// Closed form near the load, where the kernel is singular; quadrature far from it, where second
/// differences of terms growing like r^3 would cancel. At six element sizes both hold to 1e-13.
Kernels average_kernels(double x, double y, double a, double b) {
  if (std::hypot(x, y) < 12 * std::max(a, b)) {
    const Real ra = 2 * Real(a), rb = 2 * Real(b);
    Kernels sum = difference<Fourth, 3>(x, y, {-ra, 0, ra}, {-rb, 0, rb}, {1, -2, 1});
    return Kernels{}.add(1 / (4 * a * b), sum);
  }
  const Hat hat_x(a), hat_y(b);
  Kernels sum;
  for (std::size_t p = 0; p < 12; ++p)
    for (std::size_t q = 0; q < 12; ++q)
      sum.add(hat_x.weight[p] * hat_y.weight[q], point_kernels(x + hat_x.point[p], y + hat_y.point[q]));
  return sum;
}

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
  if (!(std::isfinite(value) && value > 0))
    throw InputError(std::string("the element's ") + name + " is not a positive number",
                     std::to_string(value) + " mm", "give a positive length in mm");
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
  InfluenceNumbers result{offsets, rows, dx, ds, {}};
  result.values.resize(static_cast<std::size_t>(offsets) * 9 * rows * rows);
  for (int m = 0; m < offsets; ++m)
    for (int d = 0; d < rows; ++d) {
      const Matrix3 plus = averaged(material, m * dx, d * ds, dx / 2, ds / 2);
      const Matrix3 minus = averaged(material, m * dx, -d * ds, dx / 2, ds / 2);
      for (int row = 0; row + d < rows; ++row)
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            result.at(m, row + d, i, row, j) = plus[i][j];
            result.at(m, row, i, row + d, j) = minus[i][j];
          }
    }
  return result;
}

InfluenceNumbers plane_strain_numbers(const Material& material, double ds, int rows,
                                      double reference_distance) {
  require_size(ds, "width ds");
  require_size(reference_distance, "reference distance");
  if (rows < 1)
    throw InputError("an influence table without elements was asked for", std::to_string(rows) + " rows",
                     "ask for at least one row");
  const double nu = material.poisson;
  const double c = 1 / (std::numbers::pi * material.shear_modulus);
  // Double integrals over load and receiver, divided by the receiver's width. Of ln|s| the second
  // antiderivative is s^2/2 ln|s| - 3/4 s^2; of sign(s) it is s|s|/2.
  const auto second_difference = [&](double s, auto&& f) {
    const Real h = ds;
    return static_cast<double>((f(Real(s) - h) - 2 * f(Real(s)) + f(Real(s) + h)) / h);
  };
  const auto log_part = [&](Real s) {
    return s == 0 ? Real(0) : s * s / 2 * std::log(std::abs(s) / Real(reference_distance)) - s * s * 3 / 4;
  };
  const auto sign_part = [](Real s) { return s * std::abs(s) / 2; };
  InfluenceNumbers result{1, rows, 0, ds, {}};
  result.values.assign(9 * static_cast<std::size_t>(rows) * rows, 0);
  for (int row_i = 0; row_i < rows; ++row_i)
    for (int row_j = 0; row_j < rows; ++row_j) {
      const double distance = std::abs(row_i - row_j) * ds;
      const double log_mean = second_difference(distance, log_part);
      const double sign_mean = (row_i < row_j ? -1 : 1) * second_difference(distance, sign_part);
      result.at(0, row_i, component_x, row_j, component_x) = -c * log_mean;
      result.at(0, row_i, component_s, row_j, component_s) = -c * (1 - nu) * log_mean;
      result.at(0, row_i, component_n, row_j, component_n) = -c * (1 - nu) * log_mean;
      const double coupling = (1 - 2 * nu) / (4 * material.shear_modulus) * (row_i == row_j ? 0 : sign_mean);
      result.at(0, row_i, component_s, row_j, component_n) = -coupling;
      result.at(0, row_i, component_n, row_j, component_s) = coupling;
    }
  return result;
}

} // namespace bem_contact::halfspace
