#pragma once

#include "bem_contact/contact/tangential/friction.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

/// Creepages that prescribed forces ask for, per unit of rolled distance (shift: mm).
struct Creepage {
  double x = 0, s = 0;
  int iterations = 0;  ///< tangential problems solved for them
  bool reached = true; ///< the forces are the ones prescribed
  bool beyond = false; ///< they are at or above what friction can carry
  double capacity = 0; ///< sum mu p_n dS, N
};

/// The tangential problem for given p_n with everything that is unknown in it besides p_t: the creepages of
/// prescribed forces (one: bracketed; two: Newton with finite differences and step halving), and who slips at
/// the kinetic coefficient. `task` comes with bound = mu p_n of adhesion and leaves with the bounds, rigid
/// slip and drive of the solution. Starts from `creepage` and `state`.
void solve_friction(const TangentialSystem& system, const SolverOptions& options, TangentialTask& task,
                    TangentialState& state, Creepage& creepage);

} // namespace bem_contact::contact
