#pragma once

#include "bem_contact/scene/steels.hpp"

namespace bem_contact::shakedown {

/// Fatigue limit in torsion, MPa. Nobody measures it for each grade: it is estimated from R_m by the factors
/// of the FKM guideline (Analytical Strength Assessment, 6th edition, chapter 2.2): 0.45 R_m in reversed
/// tension, 0.577 of that in torsion. Limits scatter by 10 to 20 %, and lie lower where there are large
/// inclusions.
double torsion_limit(const Steel& steel);
/// 1. Dang Van's a of steels, by the same factors.
double dang_van_a_of_steels();

/// Cycles that the steel bears under a shear stress, after the same guideline (chapter 2.4): 10^6 at the
/// limit, with the exponent 8 above it; infinitely many below it.
double cycles_of(double shear_stress, double torsion_limit);

} // namespace bem_contact::shakedown
