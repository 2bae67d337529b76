#include "tests/hard_cases/hard_case.hpp"

/// Problems without a solution end, say why, and do not pass for solved.
namespace bem_contact {
namespace {

/// Numbers that are symmetric with a positive diagonal but not positive definite: solvers that count on it
/// end, and what MPRGP and rolling on may still find fulfils every condition of contact, a minimum or not.
TEST(HardCases, IndefiniteNumbers) {
  for (const LoadKind load : {LoadKind::approach, LoadKind::force}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 8, 8, 0.5, 0.5, 1e-3, 1e-3);
    problem.load = load;
    problem.approach = 0.02;
    problem.force = 500;
    for (const int i : {component_x, component_s, component_n}) {
      const double too_much = 1.2 * problem.numbers.at(0, 0, i, 0, i);
      for (int row = 0; row < 8; ++row)
        problem.numbers.at(1, row, i, row, i) = too_much;
    }
    scenes::set_creepage(problem, 0.3, 1e-3, 1e-3, 0);
    hard::certified_or_not_converged(std::string("indefinite numbers, ") +
                                         (load == LoadKind::force ? "force" : "approach"),
                                     "the energy has no minimum", problem);
  }
}

/// No budget at all: the result is not converged, and finite.
TEST(HardCases, NoIterationsAllowed) {
  ContactProblem problem = hard::rolling_contact(16, {23000, 0.31}, scenes::steel);
  problem.force = 10000;
  scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 2e-4);
  SolverOptions none;
  none.max_outer = none.max_tangential = none.max_sweeps = 1;
  none.max_normal = 1;
  const ContactResult result = hard::certified_or_not_converged(
      "one iteration of each solver", "unlike bodies, no solver may finish", problem, none);
  EXPECT_FALSE(result.certified());
  for (const double p : result.pn)
    EXPECT_TRUE(std::isfinite(p));
}

} // namespace
} // namespace bem_contact
