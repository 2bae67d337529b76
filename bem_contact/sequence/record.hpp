#pragma once

#include "bem_contact/sequence/model_choice.hpp"
#include "bem_contact/sequence/solve_on_grid.hpp"

namespace bem_contact {

/// What is handed back of a solution: with totals about the reference point, outlines of the bodies, stresses
/// below the surface, and everything that a person should be warned of. Throws InputError for pressures that
/// are beyond elasticity.
SceneResult record_of(const ContactCase& asked, GridSolution solved, const ModelChoice& choice);

} // namespace bem_contact
