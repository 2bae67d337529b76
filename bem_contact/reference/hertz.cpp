#include "bem_contact/reference/hertz.hpp"

#include "bem_contact/reference/positive.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <numbers>

namespace bem_contact::reference {
namespace {

using std::numbers::pi;

/// 1. Least ratio of the axes of Hertz's ellipse: far below that of any contact, far above the least number.
constexpr double least_axis_ratio = 1e-12;

/// Complete elliptic integrals of the parameter m = 1 - k^2: K, D = (K - E)/m and B = K - D.
struct Elliptic {
  double k_integral = 0, d = 0, b = 0;
  double e_integral(double k) const { return b + k * k * d; } // E = B + (1 - m) D
};

/// By Carlson's symmetric integrals (DLMF 19.25.1). They take k^2 itself, so that no digit is lost where the
/// ellipse is nearly a circle or nearly a line.
Elliptic elliptic(double k) {
  const double k_integral = boost::math::ellint_rf(0.0, k * k, 1.0);
  const double d = boost::math::ellint_rd(0.0, k * k, 1.0) / 3;
  return {k_integral, d, k_integral - d};
}

/// Smaller over larger curvature, k^2 D/B, of the ellipse with the axis ratio k = b/a <= 1 (Johnson 1985,
/// eq. 4.28).
double curvature_ratio(double k) {
  const Elliptic e = elliptic(k);
  return k * k * e.d / e.b;
}

/// Axis ratio k for the curvatures. In the logarithm of k the equation is nearly linear.
double axis_ratio(double lo, double hi) {
  const auto excess = [&](double log_k) { return std::log(curvature_ratio(std::exp(log_k)) * hi / lo); };
  const double least = std::log(least_axis_ratio);
  if (excess(0) <= 0) // a circle, but for rounding
    return 1;
  if (excess(least) >= 0)
    return least_axis_ratio;
  std::uintmax_t steps = 100;
  const auto [from, to] = boost::math::tools::toms748_solve(
      excess, least, 0.0, boost::math::tools::eps_tolerance<double>(), steps);
  return std::exp((from + to) / 2);
}

struct Ellipse {
  double k, k_integral, cube_per_force; ///< a^3 = cube_per_force * F for the major axis
};

Ellipse ellipse(double a, double b, double modulus) {
  require_positive({{"curvature along x", a}, {"curvature along s", b}, {"contact modulus", modulus}});
  const double lo = std::min(a, b), hi = std::max(a, b), k = axis_ratio(lo, hi);
  const Elliptic e = elliptic(k);
  return {k, e.k_integral, 3 * e.e_integral(k) / (2 * pi * modulus * k * k * (lo + hi))};
}

HertzContact contact(const Ellipse& e, bool long_along_x, double modulus, double force, double major) {
  const double minor = e.k * major;
  HertzContact c;
  c.force = force;
  c.approach = 3 * force * e.k_integral / (2 * pi * major * modulus);
  c.semi_axis_x = long_along_x ? major : minor;
  c.semi_axis_s = long_along_x ? minor : major;
  c.max_pressure = 3 * force / (2 * pi * major * minor);
  return c;
}

} // namespace

double contact_modulus(const Material& one, const Material& other) {
  require_positive({{"shear modulus", one.shear_modulus}, {"shear modulus", other.shear_modulus}});
  return 1 / contact_compliance(one, other);
}

HertzContact hertz_by_force(double curvature_x, double curvature_s, double modulus, double force) {
  require_positive({{"force", force}});
  const Ellipse e = ellipse(curvature_x, curvature_s, modulus);
  return contact(e, curvature_x <= curvature_s, modulus, force, std::cbrt(e.cube_per_force * force));
}

HertzContact hertz_by_approach(double curvature_x, double curvature_s, double modulus, double approach) {
  require_positive({{"approach", approach}});
  const Ellipse e = ellipse(curvature_x, curvature_s, modulus);
  const double force_per_axis = approach * 2 * pi * modulus / (3 * e.k_integral); // F / a
  const double major = std::sqrt(e.cube_per_force * force_per_axis);
  return contact(e, curvature_x <= curvature_s, modulus, force_per_axis * major, major);
}

double hertz_curvature_ratio(double x_over_s) {
  require_positive({{"ratio of semi-axes", x_over_s}});
  return x_over_s >= 1 ? curvature_ratio(1 / x_over_s) : 1 / curvature_ratio(x_over_s);
}

double hertz_compression(const HertzContact& contact, double modulus, double x, double s) {
  const double a2 = contact.semi_axis_x * contact.semi_axis_x, b2 = contact.semi_axis_s * contact.semi_axis_s;
  const double x2 = x * x, s2 = s * s;
  // the confocal ellipse through the point, x^2/(a^2 + w) + s^2/(b^2 + w) = 1; inside w = 0
  double from = 0;
  if (x2 / a2 + s2 / b2 > 1) {
    const double half = (x2 + s2 - a2 - b2) / 2;
    from = half + std::sqrt(half * half + x2 * b2 + s2 * a2 - a2 * b2);
  }
  // The integrals over w from there on are Carlson's R_F and R_D (DLMF 19.16.1 and 19.16.5).
  const double a = a2 + from, b = b2 + from;
  const double sum = boost::math::ellint_rf(a, b, from) - x2 / 3 * boost::math::ellint_rd(b, from, a) -
                     s2 / 3 * boost::math::ellint_rd(a, from, b);
  return contact.max_pressure * contact.semi_axis_x * contact.semi_axis_s / modulus * sum;
}

} // namespace bem_contact::reference
