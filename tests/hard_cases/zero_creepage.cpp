#include "tests/hard_cases/hard_case.hpp"

/// Zero creepage: nothing drives equal bodies, and unlike ones drive themselves.
namespace bem_contact {
namespace {

TEST(HardCases, ZeroCreepage) {
  ContactProblem equal = hard::rolling_contact(28);
  scenes::set_creepage(equal, 0.3, 0, 0, 0);
  const ContactResult rest =
      hard::certified("zero creepage", "no slip that could scale the tolerance", equal);
  EXPECT_LT(std::hypot(rest.totals.Fx, rest.totals.Fy), 1e-9 * equal.force);
  EXPECT_EQ(rest.patches[0].slip, 0);
  scenes::set_creepage(equal, 0.3, 1e-12, 0, 0);
  const ContactResult tiny =
      hard::certified("creepage 1e-12", "slip near the rounding of displacements", equal);
  scenes::set_creepage(equal, 0.3, 1e-8, 0, 0);
  const ContactResult small =
      hard::certified("creepage 1e-8", "slip near the rounding of displacements", equal);
  EXPECT_NEAR(tiny.totals.Fx * 1e4, small.totals.Fx, 1e-3 * small.totals.Fx);
  ContactProblem unlike = hard::rolling_contact(28, {23000, 0.31}, scenes::steel);
  unlike.force = 20000;
  scenes::set_creepage(unlike, 0.3, 0, 0, 0);
  const ContactResult own =
      hard::certified("zero creepage, unlike bodies", "only the pressure drives slip", unlike);
  EXPECT_GT(std::abs(own.totals.Fx), 1e-3 * unlike.force);
}

} // namespace
} // namespace bem_contact
