#include "tests/reference/line_and_quartic.hpp"

#include "bem_contact/reference/positive.hpp"

#include <numbers>

namespace bem_contact::reference {

using std::numbers::pi;

HertzLine hertz_line_by_force(double radius, double modulus, double force) {
  require_positive({{"radius", radius}, {"contact modulus", modulus}, {"force", force}});
  const double a = std::sqrt(4 * force * radius / (pi * modulus));
  return {force, a, 2 * force / (pi * a)};
}

HertzLine hertz_line_by_half_width(double radius, double modulus, double half_width) {
  require_positive({{"radius", radius}, {"contact modulus", modulus}, {"half width", half_width}});
  const double force = pi * modulus * half_width * half_width / (4 * radius);
  return {force, half_width, 2 * force / (pi * half_width)};
}

QuarticContact steuermann_by_radius(double coefficient, double modulus, double radius) {
  require_positive({{"coefficient", coefficient}, {"contact modulus", modulus}, {"radius", radius}});
  const double a4 = radius * radius * radius * radius;
  return {64.0 / 15 * modulus * coefficient * a4 * radius, 8.0 / 3 * coefficient * a4, radius};
}

QuarticContact steuermann_by_force(double coefficient, double modulus, double force) {
  require_positive({{"coefficient", coefficient}, {"contact modulus", modulus}, {"force", force}});
  return steuermann_by_radius(coefficient, modulus, std::pow(15 * force / (64 * modulus * coefficient), 0.2));
}

} // namespace bem_contact::reference
