#pragma once

#include "bem_contact/base/tuned.hpp"

#include <cstddef>

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact {

/// 1. A curve whose range is not given reaches so many times the creepage at which linear theory reaches the
/// friction bound: at three times of it a Hertz contact slips everywhere (Vermeulen and Johnson 1964).
BEM_CONTACT_TUNED(double, automatic_reach, 3.0);
/// 1. Points of such a curve: four on each rising part.
BEM_CONTACT_TUNED(int, automatic_points, 25);
/// 1. More points of all curves are refused: at 0.1 s each they take 20 minutes.
BEM_CONTACT_TUNED(std::size_t, most_curve_points, 10000);
/// 1, of the same creepage. Step of the differences that give slopes at zero creepage. Forces are known to
/// 1e-8 of the bound, so that a slope has 5 digits; slip at the trailing edge takes 1e-3 of it off, and the
/// extrapolation from two steps takes that out.
BEM_CONTACT_TUNED(double, slope_step, 3e-3);
/// 1, of the same creepage. Step of the differences that give sensitivities at a solution. With smaller ones
/// the change of state of single elements shows.
BEM_CONTACT_TUNED(double, sensitivity_step, 0.04);
/// 1. Kalker's coefficients in place of unknown ones, for the steps and ranges of a contact that is no
/// ellipse: 4 is that of a circle.
BEM_CONTACT_TUNED(double, usual_coefficient, 4.0);
/// 1. Longest ratio of the semi-axes at which linear theory is compared: its table ends there.
BEM_CONTACT_TUNED(double, longest_ellipse, 10.0);

} // namespace bem_contact
