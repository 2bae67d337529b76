#pragma once

#include "bem_contact/base/tuned.hpp"

/// Tuned numbers of profile/bodies. For the words see base/tuned.hpp.
namespace bem_contact {

// Outlines of a body file.

/// mm. A shorter piece of an outline is a mistake. Chosen: a thousandth of the last digit of a drawing.
BEM_CONTACT_TUNED(double, shortest_outline_piece, 1e-6);
/// 1. An arc's chord may exceed its diameter by so much: a half circle with rounded ends.
BEM_CONTACT_TUNED(double, half_circle_rounding, 1e-9);
/// 1. Points of an arc among which its lowest z is looked for. Chosen.
BEM_CONTACT_TUNED(int, lowest_point_samples, 64);

} // namespace bem_contact
