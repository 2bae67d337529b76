#include "rectangle_oracle.hpp"

#include "bem_contact/halfspace/gauss.hpp"
#include "bem_contact/halfspace/settings.hpp"

#include <algorithm>
#include <cmath>

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

void add(Kernels& sum, double weight, const Kernels& k) {
  sum.xx_r3 += weight * k.xx_r3;
  sum.ss_r3 += weight * k.ss_r3;
  sum.xs_r3 += weight * k.xs_r3;
  sum.x_r2 += weight * k.x_r2;
  sum.s_r2 += weight * k.s_r2;
}

Kernels point_kernels(double x, double y) {
  const double r2 = x * x + y * y, r3 = r2 * std::sqrt(r2);
  return {x * x / r3, y * y / r3, x * y / r3, x / r2, y / r2};
}

/// The relative position of a load element and its equal receiver along one axis has a triangular density on
/// (-2a, 2a): Gauss on each half, total weight 2a (length of the load, mean over the receiver).
template <std::size_t N> struct Hat {
  std::array<double, 2 * N> point, weight;
  explicit Hat(double a) {
    const Gauss<N>& rule = gauss<N>();
    for (std::size_t g = 0; g < N; ++g) {
      const double t = (1 + rule.point[g]) / 2;
      point[g] = 2 * a * t;
      point[g + N] = -2 * a * t;
      weight[g] = weight[g + N] = a * rule.weight[g] * (1 - t);
    }
  }
};

template <std::size_t N> Kernels quadrature(double x, double y, double a, double b) {
  const Hat<N> hat_x(a), hat_y(b);
  Kernels sum;
  for (std::size_t p = 0; p < 2 * N; ++p)
    for (std::size_t q = 0; q < 2 * N; ++q)
      add(sum, hat_x.weight[p] * hat_y.weight[q], point_kernels(x + hat_x.point[p], y + hat_y.point[q]));
  return sum;
}

/// Closed form near the load, where the kernel is singular. Quadrature far from it, where second differences
/// of terms that grow like r^3 would cancel (settings.hpp has the distances).
Kernels average_kernels(double x, double y, double a, double b) {
  const double distance = std::hypot(x, y) / std::max(a, b);
  if (distance < closed_form_radius) {
    const Real ra = 2 * Real(a), rb = 2 * Real(b);
    Kernels mean;
    add(mean, 1 / (4 * a * b), difference<Fourth, 3>(x, y, {-ra, 0, ra}, {-rb, 0, rb}, {1, -2, 1}));
    return mean;
  }
  return distance < four_point_radius ? quadrature<6>(x, y, a, b) : quadrature<3>(x, y, a, b);
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
  return assemble(material, by_parity(x, s, [&](double px, double ps) {
                    // The load's element covers (-a, a) x (-b, b): the kernel is integrated over x - xi, s -
                    // eta.
                    return difference<Second, 2>(px, ps, {-Real(a), Real(a)}, {-Real(b), Real(b)}, {-1, 1});
                  }));
}

Matrix3 averaged(const Material& material, double x, double s, double a, double b) {
  return assemble(material,
                  by_parity(x, s, [&](double px, double ps) { return average_kernels(px, ps, a, b); }));
}

} // namespace bem_contact::halfspace
