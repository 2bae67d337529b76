#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::wear {

/// mm. Distance of the points of a profile that wears: a contact 1.2 mm wide, on a flange, still has twelve.
BEM_CONTACT_TUNED(double, profile_spacing, 0.1);
/// 1 (wavelength). Spacing of the knots of the cubic B-spline that spreads the wear of a row: it keeps half
/// of a wave of three times its spacing, (sin(pi/3) / (pi/3))^4 = 0.47.
BEM_CONTACT_TUNED(double, knots_per_wavelength, 3.0);
/// 1. More than this of the depth at the deepest place taken by smoothing is a warning.
BEM_CONTACT_TUNED(double, most_smoothed_off, 0.02);
/// rad. Influence functions serve a worn profile while its surface has turned by less than this from the
/// shape they were computed for. 1 mm off S1002 on 60E1 turns it by 0.146; what keeping them so far costs was
/// measured (tools/BENCHMARKS.md, section 11).
BEM_CONTACT_TUNED(double, usual_kept_turn, 0.15);

} // namespace bem_contact::wear
