#pragma once

#include "bem_contact/contact/normal/normal_system.hpp"

#include <Eigen/Core>

namespace bem_contact::contact {

struct MprgpOutcome {
  int products = 0;
  bool converged = false;
};

/// min 1/2 p'A p - b'p over 0 <= p <= system.limit by MPRGP (Dostal, Schoeberl 2005), which converges for
/// every positive definite A. Starts from p. Stops when the projected gradient is at most tolerance * max |b|
/// everywhere, or after `most` products.
MprgpOutcome solve_mprgp(const NormalSystem& system, const Eigen::VectorXd& b, double tolerance, int most,
                         WorkBudget& work, Eigen::VectorXd& p);

} // namespace bem_contact::contact
