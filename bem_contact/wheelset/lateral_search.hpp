#pragma once

#include "bem_contact/sequence/lateral_force.hpp"

namespace bem_contact {

/// The first displacement from `start` on at which the lateral forces on both rails add up to about `wanted`,
/// N; within rough_lateral_width. `force`: this sum at a displacement, nothing where the wheelset does not
/// stand. The force grows with the displacement until a wheel climbs its rail, so the search goes to that
/// side. Throws InputError, with the largest force on the way, if the wanted one is not met.
LateralRoot search_lateral(const LateralForce& force, double start, double wanted);

} // namespace bem_contact
