#include "bem_contact/fatigue/shakedown.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact::fatigue {

namespace {

void require_positive(double value, const char* name) {
  if (!(std::isfinite(value) && value > 0))
    throw InputError(fmt::format("{} cannot be {}", name, value), "it must be a positive number",
                     "Correct it.");
}

} // namespace

void require_yield_shear(double yield_shear) {
  require_positive(yield_shear, "The yield stress in shear");
}

double surface_index(const ShakedownPoint& point) {
  require_positive(point.load, "p0/k");
  return point.traction - 1 / point.load;
}

ShakedownPoint shakedown_point(const HertzPatch& patch, double yield_shear) {
  require_yield_shear(yield_shear);
  require_positive(patch.a, "The semi-axis a");
  require_positive(patch.b, "The semi-axis b");
  require_positive(patch.normal_force, "The normal force");
  const double p0 = 1.5 * patch.normal_force / (std::numbers::pi * patch.a * patch.b);
  return {.load = p0 / yield_shear, .traction = std::abs(patch.shear_force) / patch.normal_force};
}

double element_index(double shear_traction, double pressure, double yield_shear) {
  return std::max(least_element_index, (shear_traction - yield_shear) / pressure);
}

} // namespace bem_contact::fatigue
