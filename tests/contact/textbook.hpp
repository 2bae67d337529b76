#pragma once

#include "bem_contact/contact/problem.hpp"

#include <Eigen/Core>

namespace bem_contact::textbook {

/// The slow obvious version: dense matrices, LU, Kalker's active sets (Kalker 1990, sections 4.2 and 4.3:
/// NORM and TANG in turn), nothing of the solvers. Steady rolling.
struct Solution {
  Eigen::VectorXd pn; ///< MPa
  Eigen::VectorXd pt; ///< x of all elements, then s
  double approach = 0;
  bool found = false; ///< its own iterations ended
};

/// A_ij of displacement at `target`, `ahead` columns further on, under a load at `load`.
double number(const ContactProblem& problem, int target, int i, int load, int j, int ahead = 0);
/// Of the slip of steady rolling: two steps, from their definition.
double step_number(const ContactProblem& problem, int target, int i, int load, int j);

Solution solve(const ContactProblem& problem);

} // namespace bem_contact::textbook
