#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

namespace bem_contact::contact {

/// Newton's method on p = Proj(p + r S) (semi-smooth; Hueber, Stadler, Wohlmuth 2008, for given p_n), from
/// state.p.
void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            WorkBudget& work, TangentialState& state);

} // namespace bem_contact::contact
