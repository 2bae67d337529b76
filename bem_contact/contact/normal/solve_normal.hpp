#pragma once

#include "bem_contact/contact/normal/normal_system.hpp"
#include "bem_contact/contact/solver_options.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

/// min 1/2 p'A p + (gap - q cos)'p over 0 <= p <= system.limit; q is given, or it is the multiplier of the
/// force balance. `gap` contains all displacements but those of p_n.
///
/// The active set method (active_set.hpp) solves it, starting from state.sides, state.p and state.approach
/// if something is active. If its sets cycle, MPRGP solves it (solve_normal_safely).
void solve_normal(const NormalSystem& system, const Eigen::VectorXd& gap, const NormalLoad& load,
                  const SolverOptions& options, WorkBudget& work, NormalState& state);

/// Solves the same by MPRGP, from p = 0. If the force is given, the approach is bracketed.
void solve_normal_safely(const NormalSystem& system, const Eigen::VectorXd& gap, const NormalLoad& load,
                         const SolverOptions& options, WorkBudget& work, NormalState& state);

} // namespace bem_contact::contact
