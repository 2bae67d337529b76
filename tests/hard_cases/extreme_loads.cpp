#include "tests/hard_cases/hard_case.hpp"

/// One grid from a millionth of a newton to a giganewton.
namespace bem_contact {
namespace {

TEST(HardCases, ExtremeLoads) {
  ContactProblem problem = hard::rolling_contact(24);
  scenes::set_creepage(problem, 0.3, 3e-4, 2e-4, 1e-4);
  problem.force = 1e-6;
  const ContactResult least = hard::certified("load 1e-6 N", "an approach of 1e-12 mm", problem);
  EXPECT_LE(hard::contact_count(least), 4);
  problem.force = 1;
  hard::certified("load 1 N", "Hertz's area is smaller than one element; full slip", problem);
  problem.force = 1e9;
  const ContactResult most = hard::certified(
      "load 1e9 N", "the whole grid in contact: the result says that it is too small", problem);
  EXPECT_TRUE(most.trust.touches_border);
  EXPECT_EQ(hard::contact_count(most), problem.grid.size());

  // The same Hertzian contact at any force: elements and creepage with the size of the patch.
  double first = 0;
  for (const double force : {1.0, 1e9}) {
    const double size = std::cbrt(force / 40000);
    ContactProblem fitting =
        scenes::flat(scenes::steel, scenes::steel, 24, 24, 0.5 * size, 0.375 * size, 1 / 920.0, 1 / 600.0);
    fitting.force = force;
    scenes::set_creepage(fitting, 0.3, 3e-4 * size, 2e-4 * size, 1e-4);
    const ContactResult result =
        hard::certified(force > 1 ? "load 1e9 N, fitting grid" : "load 1 N, fitting grid",
                        "contacts of .2 and 100 mm with the same tolerance", fitting);
    if (force > 1) {
      EXPECT_NEAR(result.totals.Fx / force, first, 1e-6 * first) << "the same problem in other units";
    } else
      first = result.totals.Fx / force;
  }
}

} // namespace
} // namespace bem_contact
