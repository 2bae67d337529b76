#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

namespace bem_contact::contact {

/// Rolls on from the present tractions, by `steps` columns with p_n held: each rolling step is a convex
/// problem, min 1/2 p'A p - c'p over the friction discs. A transient step or a shift is one such problem.
void roll_on(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
             int steps, WorkBudget& work, TangentialState& state);

} // namespace bem_contact::contact
