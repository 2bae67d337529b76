#include "tests/hard_cases/hard_case.hpp"

/// Two patches about to merge: a double well in s, at the approach at which their number changes.
namespace bem_contact {
namespace {

ContactProblem double_well(double approach) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 24, 40, 0.4, 0.3, 1e-3, 0);
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double s = problem.rows[i / 24].s / 3;
    problem.gap[i] += 8e-3 * (s * s - 1) * (s * s - 1);
  }
  problem.load = LoadKind::approach;
  problem.approach = approach;
  return problem;
}

std::size_t patches(double approach) {
  SolverOptions options;
  options.estimate_discretisation = false;
  return solve(double_well(approach), options).patches.size();
}

TEST(HardCases, MergingPatches) {
  double apart = 0.005, joined = 0.08;
  ASSERT_EQ(patches(apart), 2u);
  ASSERT_EQ(patches(joined), 1u);
  for (int k = 0; k < 45 && joined - apart > 1e-13 * joined; ++k) {
    const double q = 0.5 * (apart + joined);
    (patches(q) > 1 ? apart : joined) = q;
  }
  ContactResult before, after;
  for (const double q : {apart, joined}) {
    ContactProblem problem = double_well(q);
    scenes::set_creepage(problem, 0.3, 4e-4, 3e-4, 2e-4);
    (q == apart ? before : after) = hard::certified(
        q == apart ? "merging patches, before" : "merging patches, after",
        "two patches one element apart, at the approach (to 13 digits) at which they join", problem);
  }
  EXPECT_EQ(before.patches.size(), 2u);
  EXPECT_EQ(after.patches.size(), 1u);
  EXPECT_NEAR(before.totals.Fz, after.totals.Fz, 1e-6 * after.totals.Fz)
      << "the force knows nothing of the count";
  EXPECT_NEAR(before.totals.Fx, after.totals.Fx, 1e-5 * after.totals.Fx);
}

} // namespace
} // namespace bem_contact
