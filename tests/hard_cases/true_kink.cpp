#include "bem_contact/base/error.hpp"
#include "tests/hard_cases/hard_case.hpp"

/// A profile with a true kink of 85 degrees, touched on both flanks.
namespace bem_contact {
namespace {

/// Rows 0 .. 15 flat, rows 16 .. 31 turned by 85 degrees, half of them on either side of the corner; each
/// flank has a parabolic gap of its own. Numbers: the flat strip's, carried between the frames.
ContactProblem kinked(double friction, double creepage) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20, 32, 0.4, 0.4, 1e-3, 0);
  for (int is = 0; is < 32; ++is) {
    ContactRow& row = problem.rows[is];
    row.delta = is < 16 ? -85 * std::numbers::pi / 180 : 0;
    row.position = row.s * tangent_of(row.delta);
    const double from_middle = std::abs(row.s) - 3;
    for (int ix = 0; ix < 20; ++ix)
      problem.gap[is * 20 + ix] += 2e-3 * from_middle * from_middle + (is < 16 ? -0.015 : 0);
  }
  scenes::rotate_numbers(problem);
  problem.force = 8000;
  if (friction > 0)
    scenes::set_creepage(problem, friction, creepage, creepage, 0);
  return problem;
}

TEST(HardCases, TrueKink) {
  const char* what =
      "contact on both flanks of a corner: pressure on one has the direction of friction on the other";
  const ContactResult smooth = hard::certified("kink of 85 degrees, frictionless", what, kinked(0, 0));
  EXPECT_GT(smooth.totals.Fy, 0) << "the steep flank is in contact";
  for (const double friction : {0.1, 0.3, 0.6})
    for (const double creepage : {1e-4, 1e-2})
      hard::certified_or_not_converged("kink of 85 degrees, friction " +
                                           std::to_string(friction).substr(0, 3) +
                                           (creepage < 1e-3 ? ", adhesion" : ", slip"),
                                       what, kinked(friction, creepage));
}

/// A groove of 10 degrees: both flanks turned by 85, friction far above tan 5 degrees. Driven inwards
/// friction carries more than the load; driven outwards it lifts the wheel out at any approach.
TEST(HardCases, SelfLockingGroove) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 16, 32, 0.4, 0.4, 1e-3, 0);
  const double delta = 85 * std::numbers::pi / 180;
  for (int is = 0; is < 32; ++is) {
    ContactRow& row = problem.rows[is];
    row.delta = is < 16 ? -delta : delta;
    row.position = {std::abs(row.s) * std::cos(delta) * (is < 16 ? -1 : 1),
                    -std::abs(row.s) * std::sin(delta)};
    const double from_middle = std::abs(row.s) - 3;
    for (int ix = 0; ix < 16; ++ix)
      problem.gap[is * 16 + ix] += 2e-3 * from_middle * from_middle;
  }
  scenes::rotate_numbers(problem);
  const auto slide = [&](double w) {
    scenes::set_creepage(problem, 0.3, 1e-4, 0, 0);
    for (int i = 0; i < problem.grid.size(); ++i)
      problem.slip_s[i] = problem.rows[i / 16].delta * w;
  };
  problem.force = 2000;
  slide(1e-2);
  hard::certified_or_not_converged("groove of 10 degrees, driven in, force",
                                   "friction carries more than the load", problem);
  slide(-1e-2);
  try {
    solve(problem);
    FAIL() << "no patch carries the force";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("No pressure balances the vertical force"));
    hard::print_refusal("groove of 10 degrees, driven out, force", "no patch carries the force",
                        "no pressure balances the vertical force");
  }
  problem.load = LoadKind::approach;
  problem.approach = 0.2;
  const ContactResult held =
      hard::certified("groove of 10 degrees, driven out, approach", "friction lifts the wheel out", problem);
  EXPECT_LT(held.totals.Fz, 0);
}

} // namespace
} // namespace bem_contact
