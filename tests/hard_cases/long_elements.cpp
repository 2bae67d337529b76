#include "tests/hard_cases/hard_case.hpp"

/// Elements 10:1, along x and along s.
namespace bem_contact {
namespace {

TEST(HardCases, LongElements) {
  double fx[2] = {};
  for (const bool along_x : {true, false}) {
    const double dx = along_x ? 1.25 : 0.125, ds = along_x ? 0.125 : 1.25;
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, along_x ? 12 : 100, along_x ? 80 : 8,
                                          dx, ds, 1 / 920.0, 1 / 600.0);
    problem.force = 60000;
    scenes::set_creepage(problem, 0.3, 5e-4, 3e-4, 1e-4);
    const ContactResult result =
        hard::certified(std::string("elements 10:1 along ") + (along_x ? "x" : "s"),
                        "the neighbour at the long side acts as strongly as the element on itself", problem);
    fx[along_x] = result.totals.Fx;
  }
  EXPECT_NEAR(fx[0], fx[1], 0.08 * fx[0]) << "5 elements across the long way";
}

} // namespace
} // namespace bem_contact
