#include "tests/hard_cases/hard_case.hpp"

/// Dissimilar materials 100:1, compressible against incompressible: the coupling at its largest.
namespace bem_contact {
namespace {

TEST(HardCases, DissimilarMaterials) {
  for (const double soft_poisson : {0.0, 0.3, 0.499})
    for (const double mu : {0.1, 0.3, 1.0}) {
      ContactProblem problem = hard::rolling_contact(28, {820, soft_poisson}, {82000, 0.28});
      problem.force = 1200;
      char name[80];
      std::snprintf(name, sizeof name, "materials 100:1, nu %.3g, friction %.1f", soft_poisson, mu);
      for (const double xi : {1e-3, 2e-2}) {
        scenes::set_creepage(problem, mu, xi, 0.3 * xi, 0);
        const ContactResult result =
            hard::certified(std::string(name) + (xi < 0.01 ? "" : ", large creepage"),
                            "pressure and shear act on each other", problem);
        EXPECT_NEAR(result.totals.Fz, 1200, 1e-3);
      }
    }
}

} // namespace
} // namespace bem_contact
