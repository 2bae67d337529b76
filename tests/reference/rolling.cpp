#include "tests/reference/rolling.hpp"

#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/reference/positive.hpp"
#include "tests/reference/line_and_quartic.hpp"

#include <numbers>

namespace bem_contact::reference {

double CarterSolution::traction(double x) const {
  const auto ellipse = [](double t) { return std::abs(t) < 1 ? std::sqrt(1 - t * t) : 0.0; };
  const double whole = ellipse(x / half_width);
  if (stick_half_width == 0)
    return friction * max_pressure * whole;
  const double centre = half_width - stick_half_width;
  return friction * max_pressure *
         (whole - stick_half_width / half_width * ellipse((x - centre) / stick_half_width));
}

CarterSolution carter(const Material& material, double radius, double half_width, double stick_half_width,
                      double friction) {
  require_positive({{"friction", friction}});
  if (!(stick_half_width >= 0 && stick_half_width <= half_width))
    throw InputError("Carter's stick zone does not fit",
                     "its half width is " + std::to_string(stick_half_width) + " mm, the contact's " +
                         std::to_string(half_width),
                     "give 0 <= a' <= a");
  const HertzLine line = hertz_line_by_half_width(radius, contact_modulus(material, material), half_width);
  const double ratio = stick_half_width / half_width;
  return {line.force,       line.max_pressure, half_width,
          stick_half_width, friction,          friction * (half_width - stick_half_width) / radius,
          1 - ratio * ratio};
}

CattaneoSolution cattaneo(const Material& material, double radius, double normal_force, double friction,
                          double tangential_force) {
  require_positive(
      {{"radius of the contact", radius}, {"normal force", normal_force}, {"friction", friction}});
  const double share = tangential_force / (friction * normal_force);
  if (!(share >= 0 && share <= 1))
    throw InputError("Cattaneo's shift has no solution",
                     "the tangential force is " + std::to_string(share) + " of mu N",
                     "give a force between 0 and mu N");
  const double theta = std::cbrt(1 - share);
  return {theta, (1 - theta * theta) * 3 * friction * normal_force * (2 - material.poisson) /
                     (8 * material.shear_modulus * radius)};
}

CombinedMaterial combined(const Material& one, const Material& other) {
  require_positive({{"shear modulus", one.shear_modulus}, {"shear modulus", other.shear_modulus}});
  const double g = 2 / (1 / one.shear_modulus + 1 / other.shear_modulus);
  return {g, g / 2 * (one.poisson / one.shear_modulus + other.poisson / other.shear_modulus),
          g / 4 *
              ((1 - 2 * one.poisson) / one.shear_modulus - (1 - 2 * other.poisson) / other.shear_modulus)};
}

double bentall_johnson_creepage(const Material& one, const Material& other, double radius,
                                double half_width) {
  require_positive({{"radius", radius}, {"half width", half_width}});
  const CombinedMaterial m = combined(one, other);
  // For mu -> 0 everything slips but two points x = +-c, between which the traction is reversed; it has no
  // resultant where half of the load lies between them, c sqrt(1 - c^2) + asin c = pi/4 (c over the half
  // width), and the creepage is the pressure's strain there: sqrt(1 - c^2) / 2 = 0.4573855.
  constexpr double factor = 0.4573855;
  return factor * 2 * m.difference / (1 - m.poisson) * half_width / radius;
}

double full_spin_moment(double friction, double normal_force, double radius) {
  require_positive({{"friction", friction}, {"normal force", normal_force}, {"radius", radius}});
  return 3 * std::numbers::pi / 16 * friction * normal_force * radius;
}

} // namespace bem_contact::reference
