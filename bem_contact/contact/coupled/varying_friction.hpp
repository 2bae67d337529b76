#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/creepage_search.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

namespace bem_contact::contact {

/// solve_friction() where Coulomb's coefficient falls with slip velocity or temperature: a fixed point. The
/// problem is solved with a coefficient held for each element, and the coefficient follows from the slip and
/// the heat of that solution, until it no longer changes (accelerated by Anderson's method). An element that
/// sticks keeps what it had: it is in adhesion under less friction, so under more as well.
///
/// The iteration begins with mu(0) on all elements, and so follows the branch that comes from adhesion. With
/// SolverOptions::from_sliding it begins with mu at the rigid slip's velocity: with everything sliding.
/// state.factor keeps the coefficients for the next outer iteration. `task` leaves with the bounds of the
/// solution. Where the iteration does not settle, state.converged is false and state.remark says so.
void solve_varying_friction(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                            TangentialTask& task, TangentialState& state, FoundCreepage& creepage);

} // namespace bem_contact::contact
