#include "tests/hard_cases/hard_case.hpp"

/// Pure spin from adhesion to full slip: the direction of slip turns about a point that wanders.
namespace bem_contact {
namespace {

TEST(HardCases, PureSpin) {
  // a circle of radius 3 mm (Hertz), 15 % of margin
  const double radius = 3, gap = 1e-3,
               force = 8.0 / 3 * scenes::steel.shear_modulus / (1 - scenes::steel.poisson) * gap * radius *
                       radius * radius;
  double before = 0;
  for (const double phi : {1e-6, 1e-4, 1e-3, 3e-3, 1e-2, 1e-1, 1e2}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 27, 27, 0.25, 0.25, gap, gap);
    problem.force = force;
    scenes::set_creepage(problem, 0.3, 0, 0, phi);
    char name[40];
    std::snprintf(name, sizeof name, "pure spin %.0e per mm", phi);
    const ContactResult result =
        hard::certified(name, "the slip turns about a point and vanishes in the element there", problem);
    EXPECT_GT(result.totals.Mz, before) << "more spin, more moment";
    before = result.totals.Mz;
    if (phi == 1e2) {
      EXPECT_NEAR(result.totals.Mz, 3 * std::numbers::pi / 16 * 0.3 * force * radius,
                  0.02 * result.totals.Mz);
    }
  }
}

} // namespace
} // namespace bem_contact
