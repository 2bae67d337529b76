#pragma once

#include "bem_contact/scene/contact_setup.hpp"

namespace bem_contact {

/// Throws InputError before anything is solved, if the pressure would be beyond elasticity
/// (largest_pressure_share) even with the prescribed force spread over the whole grid of a patch.
void require_bearable(const ContactSetup& patch);

/// Throws InputError before anything is solved, where wheel and rail would approach by more than
/// largest_approach, mm.
void require_small_approach(double approach);

/// Throws InputError where the pressure of a solution, MPa, is beyond elasticity.
void require_elastic(const ContactSetup& setup, double pressure);

} // namespace bem_contact
