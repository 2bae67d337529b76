#include "tests/hard_cases/hard_case.hpp"

/// Friction 1e-6 and 10, for equal and for unlike bodies.
namespace bem_contact {
namespace {

TEST(HardCases, ExtremeFriction) {
  for (const bool equal : {true, false})
    for (const double mu : {1e-6, 10.0}) {
      ContactProblem problem =
          hard::rolling_contact(28, equal ? scenes::steel : Material{23000, 0.31}, scenes::steel);
      problem.force = equal ? 40000 : 15000;
      scenes::set_creepage(problem, mu, mu < 1 ? 5e-3 : 5e-4, 3e-4, 0);
      const ContactResult result = hard::certified(
          std::string(mu < 1 ? "friction 1e-6" : "friction 10") + (equal ? "" : ", unlike bodies"),
          mu < 1 ? "tractions a millionth of the pressure" : "slip only at the very edge", problem);
      const double share = std::hypot(result.totals.Fx, result.totals.Fy) / (mu * problem.force);
      EXPECT_FALSE(result.trust.touches_border);
      if (mu < 1) {
        EXPECT_GT(share, equal ? 0.999999 : 0.999);
      } else {
        EXPECT_LT(share, 0.2);
      }
    }
}

} // namespace
} // namespace bem_contact
