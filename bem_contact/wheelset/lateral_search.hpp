#pragma once

#include "bem_contact/sequence/lateral_force.hpp"

namespace bem_contact {

/// The first displacement from `start` on at which the lateral forces on both rails add up to about `wanted`
/// (N; `force`: their sum, nothing where the wheelset does not stand), to the side on which the force is met
/// if it grows with the displacement, as it does until a wheel climbs its rail; within rough_lateral_width.
/// Throws InputError, with what the force reaches, where it is not met.
LateralRoot search_lateral(const LateralForce& force, double start, double wanted);

} // namespace bem_contact
