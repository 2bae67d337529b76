#pragma once

#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/uses/shakedown/enclosing_ball.hpp"

#include <span>

namespace bem_contact::shakedown {

/// The largest shear stress of Dang Van over a passage, MPa (Dang Van, Griveau and Message, in: Biaxial and
/// multiaxial fatigue, EGF 3 (1989) 479): the largest of tau(t) + a sigma_h(t), with tau half the difference
/// of the outer principal stresses of the deviator less the middle of the smallest ball about its path, and
/// sigma_h the hydrostatic stress, a third of the trace, tension positive. Fatigue begins where it exceeds
/// the fatigue limit in torsion. `ball`: about the deviators of the stresses.
double dang_van(std::span<const halfspace::Stress> stresses, const Ball& ball, double a);

/// Crossland's stress over a passage, MPa (Crossland, Int. Conf. Fatigue of Metals, London (1956) 138): the
/// radius of that ball (the amplitude of the square root of J2) plus alpha times the largest hydrostatic
/// stress. Fatigue begins where it exceeds the fatigue limit in torsion.
double crossland(std::span<const halfspace::Stress> stresses, const Ball& ball, double alpha);

/// Crossland's alpha of a steel with Dang Van's a: both follow from its limits in torsion t and in reversed
/// bending b, a = 3 (t/b - 1/2) and alpha = 3 t/b - sqrt(3).
double crossland_alpha(double a);

} // namespace bem_contact::shakedown
