#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/rolling_step.hpp"

namespace bem_contact {

/// The slip of one step, mm, as a sum over displacements u = -A p of now and of one and two steps ago:
///     S(x) = length w(x) + sum_k present[k] u_now(x + k dx) + sum_k former[k] u_k(x + k columns dx).
/// Steady rolling: u_k(x) = u_now(x), so that all weights are at present. Transient rolling: the grid moves
/// on by one column a step. Shift: the grid lies still in the material.
struct SlipStep {
  std::array<double, 3> present{}, former{};
  int columns = 0;
  double length = 1; ///< mm; 1 where the rigid slip is given in mm
};

inline SlipStep slip_step(const ContactProblem& problem) {
  switch (problem.motion) {
  case MotionKind::steady:
    return {rolling_step, {}, 1, problem.grid.dx};
  case MotionKind::transient: // two steps back as in steady rolling, but for the first step
    if (problem.previous.size() < 2)
      return {{1, 0, 0}, {0, -1, 0}, 1, problem.grid.dx};
    return {{rolling_step[0], 0, 0}, {0, rolling_step[1], rolling_step[2]}, 1, problem.grid.dx};
  case MotionKind::shift:
    break;
  }
  return {{1, 0, 0}, {0, -1, 0}, 0, 1};
}

} // namespace bem_contact
