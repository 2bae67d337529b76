#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <vector>

namespace bem_contact::contact {

/// Newton's method on p = Proj(p + r S) (semi-smooth; Hueber, Stadler, Wohlmuth 2008, for given p_n), from
/// state.p.
void newton(const TangentialSystem& system, const TangentialTask& task, const SolverOptions& options,
            WorkBudget& work, TangentialState& state);

/// Shear forces that are prescribed, and the creepages that are unknown for them.
struct PrescribedForces {
  std::vector<int> components; ///< component_x, component_s: which of them
  Eigen::Vector2d force;       ///< sum p_x dS and sum p_s share dS, N
  Eigen::VectorXd share;       ///< slip along s under a unit creepage along s; field
  double tolerance = 0;        ///< of the forces, N
  Eigen::Vector2d start;       ///< creepages along x and s to begin with
};

/// Creepages along x and s, and what a unit of the force along x or s changes of each: 1/N (shift: mm/N).
/// nan: the creepage is given, or no force depends on it.
struct ForcedCreepage {
  Eigen::Vector2d creepage;
  Eigen::Vector2d compliance = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// The same with the creepages as further unknowns, whose equations are the forces: the system of a step has
/// as many columns more. Nothing where it did not converge; then task and state are of its last step.
/// `task` comes without these creepages and leaves with them.
std::optional<ForcedCreepage> newton_for_forces(const TangentialSystem& system,
                                                const PrescribedForces& forces, const SolverOptions& options,
                                                WorkBudget& work, TangentialTask& task,
                                                TangentialState& state);

/// Adds the slip of creepages to the rigid slip and drive of a task.
void add_creepage(const TangentialSystem& system, const Eigen::VectorXd& share,
                  const Eigen::Vector2d& creepage, TangentialTask& task);

} // namespace bem_contact::contact
