#include "bem_contact/uses/shakedown/fatigue_limits.hpp"

#include <cmath>
#include <limits>

namespace bem_contact::shakedown {

namespace {

/// 1. Reversed tension over R_m of steel, and torsion over reversed tension (FKM guideline, chapter 2.2).
constexpr double tension_factor = 0.45, torsion_factor = 0.577;
/// 1. Cycles at the knee of the Woehler line of shear stresses, and its exponent (FKM guideline,
/// chapter 2.4).
constexpr double knee_cycles = 1e6, exponent = 8;

} // namespace

double torsion_limit(const Steel& steel) {
  return torsion_factor * tension_factor * steel.tensile_strength;
}

double dang_van_a_of_steels() {
  return 3 * (torsion_factor - 0.5);
}

double cycles_of(double shear_stress, double torsion_limit) {
  return shear_stress <= torsion_limit ? std::numeric_limits<double>::infinity()
                                       : knee_cycles * std::pow(shear_stress / torsion_limit, -exponent);
}

} // namespace bem_contact::shakedown
