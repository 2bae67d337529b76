#pragma once

#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"

#include <cmath>
#include <numbers>

namespace bem_contact::fatigue {

/// An elliptical contact after Hertz, its load and shear.
struct HertzPatch {
  double a = 0, b = 0;     ///< semi-axes, mm
  double normal_force = 0; ///< N
  double shear_force = 0;  ///< resultant, N
};

/// The point of a Hertz contact, p0 = 3 Fz / (2 pi a b): its index is mu used - 2 pi a b k / (3 Fz).
inline ShakedownPoint shakedown_point(const HertzPatch& patch, double yield_shear) {
  const double p0 = 1.5 * patch.normal_force / (std::numbers::pi * patch.a * patch.b);
  return {.load = p0 / yield_shear, .traction = std::abs(patch.shear_force) / patch.normal_force};
}

} // namespace bem_contact::fatigue
