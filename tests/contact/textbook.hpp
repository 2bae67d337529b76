#pragma once

#include "bem_contact/contact/problem.hpp"

#include <Eigen/Core>

namespace bem_contact::textbook {

/// The slow obvious version: dense matrices, LU, Kalker's active sets (Kalker 1990, sections 4.2 and 4.3:
/// NORM and TANG in turn), nothing of the solvers. Steady rolling, and a shift from rest. Where the turns do
/// not end (friction and coupling that are large together) all conditions at once, with friction growing from
/// zero in steps. What is found is checked against every condition.
struct Solution {
  Eigen::VectorXd pn; ///< MPa
  Eigen::VectorXd pt; ///< x of all elements, then s
  double approach = 0;
  bool found = false; ///< the iterations ended, and all conditions hold
};

/// A_ij of displacement at `target`, `ahead` columns further on, under a load at `load`.
double number(const ContactProblem& problem, int target, int i, int load, int j, int ahead = 0);
/// Of the slip of steady rolling: two steps, from their definition. Of a shift: the number itself.
double step_number(const ContactProblem& problem, int target, int i, int load, int j);

/// The problem in matrices: e = gap - q cosine + nn p_n + nt p_t, S = rigid - tn p_n - tt p_t.
struct Dense {
  explicit Dense(const ContactProblem& problem);

  int n = 0;
  bool by_force = false;
  double force = 0, approach = 0; ///< over an element's area
  Eigen::VectorXd gap, cosine, sine, rigid, mu;
  Eigen::MatrixXd nn, nt, tt, tn;
};

/// Whether all conditions hold, to 1e-9 (the direction of slip: 1e-6 where it is small).
bool holds(const Dense& dense, const Solution& solution);

/// All conditions at once: Newton's method for given sets (exterior, adhesion, slip), which then change.
/// Friction grows from zero in steps, halved where the sets do not settle.
Solution by_steps(const Dense& dense);

Solution solve(const ContactProblem& problem);

} // namespace bem_contact::textbook
