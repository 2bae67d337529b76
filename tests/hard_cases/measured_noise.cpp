#include "tests/hard_cases/hard_case.hpp"

#include <random>

/// A gap with the noise of a measurement: many small patches, lone elements among them.
namespace bem_contact {
namespace {

TEST(HardCases, MeasuredNoise) {
  for (const double noise : {1e-3, 1e-2, 5e-2}) {
    std::mt19937 random(7);
    std::normal_distribution<> height(0, noise);
    ContactProblem problem = hard::rolling_contact(40);
    for (double& h : problem.gap)
      h += height(random);
    problem.force = 20000;
    scenes::set_creepage(problem, 0.3, 4e-4, 2e-4, 2e-4);
    const ContactResult result = hard::certified(
        "noise of " + std::to_string(noise).substr(0, 5) + " mm",
        "gap with uncorrelated noise, approach " + std::to_string(0.05).substr(0, 4) + " mm", problem);
    EXPECT_NEAR(result.totals.Fz, 20000, 1e-2);
    if (noise > 2e-2) {
      EXPECT_GT(result.patches.size(), 5u);
    }
  }
}

} // namespace
} // namespace bem_contact
