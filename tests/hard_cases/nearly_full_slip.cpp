#include "tests/hard_cases/hard_case.hpp"

/// Nearly full slip from both sides: the last element in adhesion, and none.
namespace bem_contact {
namespace {

ContactProblem creeping(double xi) {
  ContactProblem problem = hard::rolling_contact(28);
  scenes::set_creepage(problem, 0.3, xi, 0.5 * xi, 0);
  return problem;
}

int adhering(double xi) {
  SolverOptions options;
  options.estimate_discretisation = false;
  const ContactResult result = solve(creeping(xi), options);
  EXPECT_TRUE(result.certified()) << xi << ' ' << result.trust.solver_note;
  return static_cast<int>(std::count(result.state.begin(), result.state.end(), ElementState::adhesion));
}

TEST(HardCases, NearlyFullSlip) {
  double partial = 1e-4, full = 1e-1;
  ASSERT_GT(adhering(partial), 100);
  ASSERT_EQ(adhering(full), 0);
  for (int k = 0; k < 40 && full - partial > 1e-10 * full; ++k) {
    const double xi = std::sqrt(partial * full);
    (adhering(xi) > 0 ? partial : full) = xi;
  }
  const ContactResult below =
      hard::certified("nearly full slip, from below",
                      "one element in adhesion, at the creepage (to 10 digits) at which it starts to slip",
                      creeping(partial));
  const ContactResult above =
      hard::certified("nearly full slip, from above", "no element in adhesion, at a creepage larger by 1e-10",
                      creeping(full));
  EXPECT_GT(below.patches[0].adhesion, 0);
  EXPECT_LE(below.patches[0].adhesion, 4);
  EXPECT_EQ(above.patches[0].adhesion, 0);
  EXPECT_NEAR(below.totals.Fx, above.totals.Fx, 1e-6 * above.totals.Fx);
}

} // namespace
} // namespace bem_contact
