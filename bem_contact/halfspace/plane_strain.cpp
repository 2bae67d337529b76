#include "bem_contact/halfspace/plane_strain.hpp"

#include <cmath>
#include <numbers>

namespace bem_contact::halfspace {

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

} // namespace bem_contact::halfspace
