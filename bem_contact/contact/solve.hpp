#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/work.hpp"
#include "bem_contact/contact/workspace.hpp"

namespace bem_contact {

/// A guess at the solution; fields of the problem's grid.
struct StartingPoint {
  std::vector<double> px, ps, pn; ///< MPa
  double approach = 0;            ///< mm
};

struct SolverOptions {
  double tolerance = 1e-8;  ///< of the solvers; the certificate asks for 1e-6
  int max_outer = 50;       ///< normal-tangential (Panagiotopoulos) iterations
  int max_normal = 200;     ///< active-set changes
  int max_tangential = 250; ///< Newton steps for given p_n
  int max_sweeps = 1000;    ///< where Newton fails
  bool only_newton = false; ///< nothing else where Newton fails
  bool estimate_discretisation = true;
  bool coarse_start = true; ///< without a start of its own a large problem starts from larger elements
  /// Where to start from instead of a coarse grid; a guess on another grid or without pressure is passed
  /// over.
  const StartingPoint* start = nullptr;
  WorkBudget* work = nullptr;     ///< of a case of several problems; null: each has one of its own
  Workspace* workspace = nullptr; ///< what earlier solutions prepared; null: all is made for this one
};

/// Solves the normal problem or steady rolling. No contact: a result with zero force and no patches.
/// Does not throw for lack of convergence: the result says `converged == false` and why. Throws
/// ConvergenceError where the work allowed is used up.
ContactResult solve(const ContactProblem& problem, const SolverOptions& options = {});

/// The independent check: direct sums over the influence numbers, nothing of the solver's operator. Above 3e8
/// terms (about 10,000 elements in contact) by FFT, which direct sums at 100 elements must confirm to 1e-9;
/// direct sums everywhere where they do not.
Certificate certify(const ContactProblem& problem, const ContactResult& result);

} // namespace bem_contact
