#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

namespace bem_contact::contact {

/// Friction for given p_n and rigid slip with a static and a kinetic coefficient (ContactProblem::kinetic).
/// All elements but state.held have the static bound first; an element that slips has the kinetic bound from
/// then on. The set of those, state.slipped, only grows, so this ends. `task` leaves with the bounds of the
/// solution.
void solve_with_kinetic_friction(const TangentialSystem& system, const SolverOptions& options,
                                 WorkBudget& work, TangentialTask& task, TangentialState& state);

} // namespace bem_contact::contact
