#include "bem_contact/contact/slip_step.hpp"

namespace bem_contact {

SlipStep slip_step(const ContactProblem& problem) {
  switch (problem.motion) {
  case MotionKind::steady:
    return {rolling_step, {}, 1, problem.grid.dx};
  case MotionKind::transient: // the first step knows one former step only
    if (problem.previous.size() < 2)
      return {{1, 0, 0}, {0, -1, 0}, 1, problem.grid.dx};
    return {{rolling_step[0], 0, 0}, {0, rolling_step[1], rolling_step[2]}, 1, problem.grid.dx};
  case MotionKind::shift:
    break;
  }
  return {{1, 0, 0}, {0, -1, 0}, 0, 1};
}

} // namespace bem_contact
