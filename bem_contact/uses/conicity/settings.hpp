#pragma once

#include "bem_contact/base/tuned.hpp"

/// The tuned numbers of this room (base/tuned.hpp).
namespace bem_contact::conicity {

/// mm. Lateral displacements of the table are at most this far apart. The standard's reference functions have
/// this step.
BEM_CONTACT_TUNED(double, lateral_step, 0.1);
/// mm, arc length on a profile. Where a contact point moves by more between two displacements, another one is
/// put between them: a jump of the contact becomes a steep stretch. Chosen: a twentieth of a contact's width.
BEM_CONTACT_TUNED(double, largest_move, 0.5);
/// mm. No two displacements get nearer. A jump of 2 mm in the radius difference, placed 2e-3 mm off, changes
/// the conicity of an amplitude of 3 mm by less than 1e-3 of itself.
BEM_CONTACT_TUNED(double, smallest_lateral_step, 2e-3);
/// mm. The table reaches so much farther than the largest amplitude, because a motion need not have its
/// middle at y = 0.
BEM_CONTACT_TUNED(double, beyond_amplitude, 2.0);
/// mm. Both wheels stand on their rails when the heights of the axle that they ask for differ by less.
BEM_CONTACT_TUNED(double, height_difference, 1e-9);
/// mm. A motion whose width differs by more from the one asked for stands at a jump of the width: there is
/// none of this amplitude.
BEM_CONTACT_TUNED(double, width_tolerance, 1e-6);

/// mm. The cone in the middle is looked at so far to either side: the smallest amplitude that is usual.
BEM_CONTACT_TUNED(double, middle_reach, 1.0);
/// 1. tan gamma in the middle below which the cone is called negative: less is a cylinder, and rounding.
BEM_CONTACT_TUNED(double, least_negative_cone, -1e-5);

} // namespace bem_contact::conicity
