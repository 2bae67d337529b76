#include "bem_contact/contact/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact {

double exponential_fall(double v) {
  return std::exp(-v);
}

double FallingFriction::factor(double slip_velocity) const {
  return ratio == 1 ? 1 : ratio + (1 - ratio) * fall(slip_velocity / scale);
}

FallingFriction exponential_friction(double mu_kin, double mu_1, double half) {
  return {mu_kin / (mu_kin + mu_1), half / std::numbers::ln2};
}

FallingFriction polach_friction(double a, double b) {
  constexpr double mm_per_m = 1000;
  return {a, mm_per_m / b};
}

double HotFriction::factor(double temperature) const {
  return 1 - (1 - ratio) * std::clamp((temperature - from) / (to - from), 0.0, 1.0);
}

double ThermalBody::effusivity() const {
  constexpr double megapascal = 1e-6; // J/(m^3 K) in MPa/K; W/(m K) is N/(s K)
  return std::sqrt(conductivity * density * heat_capacity * megapascal);
}

} // namespace bem_contact
