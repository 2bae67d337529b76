#include "tests/reference/conformal.hpp"

#include "bem_contact/reference/positive.hpp"

#include <boost/math/tools/roots.hpp>

#include <cstdint>
#include <numbers>

namespace bem_contact::reference {
namespace {

using std::numbers::pi;

void require_half_angle(double half_angle) {
  if (!(half_angle > 0 && half_angle < pi))
    throw InputError("Persson's contact has no such half angle", std::to_string(half_angle) + " rad",
                     "give an angle between 0 and pi");
}

void require_harmonic(int n, double radius) {
  require_positive({{"radius", radius}});
  if (n < 2)
    throw InputError("Michell's solution has no such harmonic",
                     "n = " + std::to_string(n) + "; n = 1 is a rigid motion", "give n >= 2");
}

} // namespace

double plane_strain_modulus(const Material& material) {
  require_positive({{"shear modulus", material.shear_modulus}});
  return 2 * material.shear_modulus / (1 - material.poisson);
}

double persson_clearance(double half_angle) {
  require_half_angle(half_angle);
  const double b2 = std::tan(half_angle / 2) * std::tan(half_angle / 2);
  return (2 - std::log1p(b2) - 2 * b2 * b2) / (pi * (b2 + 1) * b2);
}

double persson_half_angle(double clearance) {
  if (!(std::isfinite(clearance) && clearance >= 0))
    throw InputError("Persson's half angle has no solution", "E1* dR/Q is " + std::to_string(clearance),
                     "give a clearance of 0 or more");
  // The clearance falls with the angle and is negative at pi/2.
  std::uintmax_t steps = 1000;
  const auto [from, to] = boost::math::tools::bracket_and_solve_root(
      [&](double angle) { return persson_clearance(angle) - clearance; }, pi / 4, 2.0, false,
      boost::math::tools::eps_tolerance<double>(), steps);
  return (from + to) / 2;
}

double persson_pressure(double half_angle, double phi) {
  require_half_angle(half_angle);
  if (std::abs(phi) >= half_angle)
    return 0;
  const double b = std::tan(half_angle / 2), y = std::tan(phi / 2), b2 = b * b;
  const double root = std::sqrt(b2 - y * y), hyp = std::sqrt(b2 + 1);
  // ln((h + r)/(h - r)) = 2 atanh(r/h)
  return 2 * root / (pi * hyp * (1 + y * y)) + std::atanh(root / hyp) / (pi * b2 * (1 + b2));
}

std::array<std::array<double, 2>, 2> michell_pair(const Material& material, double radius, int n) {
  if (n == 0) {
    require_positive({{"radius", radius}});
    return {{{2 * radius / plane_strain_modulus(material), 0}, {0, 0}}};
  }
  require_harmonic(n, radius);
  const double c = 4 * radius / (plane_strain_modulus(material) * (static_cast<double>(n) * n - 1));
  return {{{c * n, c}, {-c, -c * n}}};
}

RadialDisplacement michell_disc(const Material& material, double radius, int n) {
  require_harmonic(n, radius);
  const double c = radius / (4 * material.shear_modulus), kappa = 3 - 4 * material.poisson;
  return {-c * (kappa / (n + 1) + 1.0 / (n - 1)), -c * (kappa / (n + 1) - 1.0 / (n - 1))};
}

RadialDisplacement michell_hole(const Material& material, double radius, int n) {
  require_harmonic(n, radius);
  const double c = radius / (4 * material.shear_modulus), kappa = 3 - 4 * material.poisson;
  return {c * (kappa / (n - 1) + 1.0 / (n + 1)), c * (-kappa / (n - 1) + 1.0 / (n + 1))};
}

RadialDisplacement michell_line_load(const Material& material, double load, double theta) {
  const double half = std::abs(std::sin(theta / 2));
  if (!(half > 0))
    throw InputError("the displacement under a line load is infinite", "theta = " + std::to_string(theta),
                     "ask for another point");
  const double c = 4 * load / (pi * plane_strain_modulus(material)), logarithm = std::log(2 * half);
  return {c * (-std::cos(theta) * logarithm - 0.25), c * std::sin(theta) * (logarithm - 0.5)};
}

std::span<const SeatEntry> sphere_in_seat() {
  static constexpr std::array<SeatEntry, 5> table = {{
      {20, 0.033167, 4.0856, 1.087},
      {30, 0.120491, 1.91207, 1.202},
      {40, 0.317609, 1.15541, 1.386},
      {50, 0.721282, 0.81021, 1.679},
      {60, 1.55488, 0.62857, 2.174},
  }};
  return table;
}

} // namespace bem_contact::reference
