#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace bem_contact::shakedown {

/// A steel as its standard has it: the least values that are allowed.
struct Steel {
  std::string_view name;            ///< "ER7"
  std::string_view standard;        ///< "EN 13262"
  double tensile_strength = 0;      ///< R_m, MPa
  std::optional<double> yield = {}; ///< R_eH, MPa; the standard of rails has none

  /// Fatigue limit in torsion, MPa, and Dang Van's a. Nobody measures them for each grade: they are
  /// estimated from R_m by the factors of the FKM guideline (Analytical Strength Assessment, 6th edition,
  /// chapter 2.2): 0.45 R_m in reversed tension, 0.577 of that in torsion. Limits scatter by 10 to 20 %, and
  /// lie lower where there are large inclusions.
  double torsion_limit() const;
  static double dang_van_a();
  std::optional<double> yield_shear() const; ///< k = R_eH / sqrt(3), MPa
};

/// Rails (EN 13674-1:2011) and wheels (EN 13262:2004+A2:2011).
std::span<const Steel> steels();
/// Throws InputError for a name that is none of them, with the nearest.
const Steel& steel_of(std::string_view name);

/// Cycles that the steel bears under a shear stress, after the same guideline (chapter 2.4): 10^6 at the
/// limit, with the exponent 8 above it; infinitely many below it.
double cycles_of(double shear_stress, double torsion_limit);

} // namespace bem_contact::shakedown
