#pragma once

#include "bem_contact/curves/creep_state.hpp"
#include "bem_contact/reference/creep_coefficients.hpp"

#include <optional>

namespace bem_contact {

/// Kalker's linear theory for the Hertz contact that is nearest to a solved one: what small creepages would
/// give on an ellipse between half-spaces, if nothing slipped.
struct LinearTheory {
  double semi_axis_x = 0, semi_axis_s = 0; ///< mm
  double tilt = 0;                         ///< of the ellipse out of the axes x and s, rad; taken as 0
  double deviation = 0;                    ///< of the undeformed distance from a quadratic, over the approach
  double shear_modulus = 0, poisson = 0;   ///< of the pair, MPa
  reference::CreepCoefficients coefficients;
  CreepMatrix slopes{};

  double c() const; ///< sqrt(a b), mm
};

/// Nothing where the contact has no ellipse: several patches, a distance that is not curved both ways, or
/// semi-axes beyond the table of coefficients.
std::optional<LinearTheory> linear_theory(const SceneResult& result, const Material& rail,
                                          const Material& wheel);

} // namespace bem_contact
