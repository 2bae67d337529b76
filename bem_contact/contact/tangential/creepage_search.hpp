#pragma once

#include "bem_contact/contact/solver_options.hpp"
#include "bem_contact/contact/tangential/tangential_system.hpp"

#include <limits>

namespace bem_contact::contact {

/// Creepages that prescribed shear forces ask for, per unit of rolled distance (shift: mm).
struct FoundCreepage {
  double x = 0, s = 0;
  /// ForcedCreepage::compliance of the last solution that Newton's method found.
  double compliance_x = std::numeric_limits<double>::quiet_NaN();
  double compliance_s = std::numeric_limits<double>::quiet_NaN();
  bool near = false;   ///< x and s are near the ones looked for: they are known from somewhere
  int iterations = 0;  ///< tangential problems solved for them
  bool reached = true; ///< the forces are the prescribed ones
  bool beyond = false; ///< they are at or above what friction can carry
  double capacity = 0; ///< sum mu p_n dS, N
};

/// Friction for given p_n. It also finds the creepages of prescribed forces (as unknowns of Newton's method;
/// where that ends without an answer, one is bracketed, and two are found by Newton with finite differences
/// and step halving) and which elements slip at the kinetic coefficient. `task` comes with bound = mu p_n of
/// adhesion and leaves with the bounds, rigid slip and drive of the solution. Starts from `state` and from
/// `creepage`; where nothing is known of that yet, from the creepages without a mean slip.
void solve_friction(const TangentialSystem& system, const SolverOptions& options, WorkBudget& work,
                    TangentialTask& task, TangentialState& state, FoundCreepage& creepage);

} // namespace bem_contact::contact
