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

std::vector<double> element_stiffness(const ContactProblem& problem) {
  const SlipStep step = slip_step(problem);
  std::vector<double> out;
  for (int row = 0; row < problem.grid.ms; ++row) {
    double mean = 0;
    for (const int c : {component_x, component_s})
      for (int k = 0; k <= rolling_columns; ++k)
        mean += 0.5 * step.present[k] * problem.numbers.at(k, row, c, row, c);
    out.push_back(1 / mean);
  }
  return out;
}

} // namespace bem_contact
