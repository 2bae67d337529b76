#pragma once

#include "bem_contact/contact/normal/normal_system.hpp"

#include <Eigen/Core>

#include <vector>

namespace bem_contact::contact {

/// A pressure and its displacement u = A p; fields of the grid.
struct Response {
  Eigen::VectorXd p, u;
  Boxes known;      ///< where u is known; no box at all: nowhere
  int products = 0; ///< of conjugate gradients, so far
};

/// Solves A_CC p = rhs on the elements of the list by preconditioned conjugate gradients, starting from
/// response.p. The residual falls below `target` everywhere: runs in single precision correct p until double
/// precision agrees. False if it does not get there; then response.known is as before.
bool conjugate_gradients(const NormalSystem& system, const std::vector<int>& list, const Eigen::VectorXd& rhs,
                         double target, WorkBudget& work, Response& response);

} // namespace bem_contact::contact
