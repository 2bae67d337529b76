#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

namespace bem_contact::contact {

/// Friction for given p_n and given rigid slip, from state.p: Newton's method; if it fails, Gauss-Seidel
/// sweeps; if they fail too, rolling on and Newton's method again. state.remark says what failed.
void solve_tangential(const TangentialSystem& system, const TangentialTask& task,
                      const SolverOptions& options, WorkBudget& work, TangentialState& state);

} // namespace bem_contact::contact
