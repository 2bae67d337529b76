#include "tests/hard_cases/hard_case.hpp"

/// Opposite rolling. x is the direction of rolling (base/conventions.hpp), so rolling the other way is the
/// same problem described in turned axes; there are two ways to turn them, and they must agree.
namespace bem_contact {
namespace {

TEST(HardCases, OppositeRolling) {
  // unlike bodies, a gap without any symmetry, an inclined strip
  ContactProblem forwards = hard::rolling_contact(28, {23000, 0.31}, scenes::steel);
  forwards.force = 15000;
  const int mx = forwards.grid.mx, ms = forwards.grid.ms;
  for (int i = 0; i < forwards.grid.size(); ++i) {
    const double x = forwards.grid.x(i % mx), s = forwards.rows[i / mx].s;
    forwards.gap[i] += 3e-4 * x * s + 2e-5 * x * x * x;
  }
  const double xi = 4e-4, eta = 3e-4, phi = 5e-5;
  scenes::set_creepage(forwards, 0.3, xi, eta, phi);
  const ContactResult ahead = hard::certified("rolling forwards", "asymmetric gap, unlike bodies", forwards);

  // a) mirrored in x: x' = -x. Longitudinal creepage and spin change sign, lateral creepage does not.
  ContactProblem mirrored = forwards;
  for (int is = 0; is < ms; ++is)
    for (int ix = 0; ix < mx; ++ix)
      mirrored.gap[is * mx + ix] = forwards.gap[is * mx + mx - 1 - ix];
  scenes::set_creepage(mirrored, 0.3, -xi, eta, -phi);
  const ContactResult a =
      hard::certified("rolling backwards, mirrored in x", "rolling against x (chi = 180 degrees)", mirrored);

  // b) turned by 180 degrees about n: x' = -x, s' = -s. Both creepages change sign, spin does not.
  ContactProblem turned = forwards;
  for (int i = 0; i < forwards.grid.size(); ++i)
    turned.gap[i] = forwards.gap[forwards.grid.size() - 1 - i];
  scenes::set_creepage(turned, 0.3, -xi, -eta, phi);
  const ContactResult b =
      hard::certified("rolling backwards, turned about n", "rolling against x (chi = 180 degrees)", turned);

  // back in the axes of the rail: a) (Fx, Fy, Mz) = (-, +, -), b) (-, -, +)
  const double scale = 2e-6 * 0.3 * forwards.force;
  EXPECT_NEAR(-a.totals.Fx, -b.totals.Fx, scale);
  EXPECT_NEAR(a.totals.Fy, -b.totals.Fy, scale);
  EXPECT_NEAR(-a.totals.Mz, b.totals.Mz, 3 * scale);
  EXPECT_NEAR(a.totals.approach, b.totals.approach, 1e-6 * a.totals.approach);
  // rolling is not reversible: the same rigid slip, but what has rolled in first is the other side
  EXPECT_GT(std::abs(-a.totals.Fx - ahead.totals.Fx) + std::abs(a.totals.Fy - ahead.totals.Fy),
            1e-3 * forwards.force);
  EXPECT_GT(-a.totals.Fx, 0) << "the same sliding drags the rail the same way";
  EXPECT_GT(a.totals.Fy, 0);
}

} // namespace
} // namespace bem_contact
