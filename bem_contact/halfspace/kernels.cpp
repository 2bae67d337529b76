#include "bem_contact/halfspace/kernels.hpp"

#include "bem_contact/base/error.hpp"

#include <numbers>
#include <string>

namespace bem_contact::halfspace {

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
    throw InputError(std::string("The element's ") + name + " is not a positive number",
                     value > 0 ? "it lies outside 1e-30 .. 1e30 mm" : std::to_string(value) + " mm",
                     "Give a positive length in mm.");
}

} // namespace bem_contact::halfspace
