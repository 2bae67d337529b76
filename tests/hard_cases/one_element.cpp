#include "tests/hard_cases/hard_case.hpp"

/// One element in contact: its answer can be written down.
namespace bem_contact {
namespace {

TEST(HardCases, OneElement) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 5, 5, 1, 1, 1, 1);
  problem.load = LoadKind::approach;
  problem.approach = 1e-4;
  const auto number = [&](int m, int c) { return problem.numbers.at(m, 2, c, 2, c); };
  const double self = number(0, component_n), pn = 1e-4 / self;
  const double step =
      1.5 * number(0, component_x) - 2 * number(1, component_x) + 0.5 * number(2, component_x);
  scenes::set_creepage(problem, 0.3, 1e-7, 0, 0);
  const ContactResult held = hard::certified("one element, adhesion", "a patch of one element", problem);
  ASSERT_EQ(hard::contact_count(held), 1);
  EXPECT_NEAR(held.totals.Fz, pn, 1e-9 * pn);
  EXPECT_NEAR(held.totals.Fx, 1e-7 / step, 1e-7 * held.totals.Fx) << "S = w dx - B p = 0";
  scenes::set_creepage(problem, 0.3, 3e-2, 4e-2, 0);
  const ContactResult slipping = hard::certified("one element, slip", "a patch of one element", problem);
  EXPECT_NEAR(std::hypot(slipping.totals.Fx, slipping.totals.Fy), 0.3 * pn, 1e-9 * pn);

  ContactProblem unlike = scenes::flat({820, 0.3}, scenes::steel, 5, 5, 1, 1, 1, 1);
  unlike.force = 0.5;
  scenes::set_creepage(unlike, 0.5, 1e-3, 0, 0);
  EXPECT_EQ(hard::contact_count(
                hard::certified("one element, unlike bodies",
                                "a patch of one element, pressure and shear act on each other", unlike)),
            1);
}

} // namespace
} // namespace bem_contact
