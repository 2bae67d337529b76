#include "bem_contact/contact/coupled/contact_operators.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <utility>

namespace bem_contact {
namespace {

ContactProblem roller(const Material& lower, const Material& upper, int n) {
  ContactProblem problem = scenes::flat(lower, upper, n, n, 12.0 / n, 12.0 / n, 1e-3, 1.4e-3);
  problem.force = 15000;
  return problem;
}

TEST(Coupling, UnlikeMaterialsConverge) {
  ContactProblem problem = roller({23000, 0.31}, {82000, 0.1}, 32);
  for (const double mu : {0.1, 0.3, 1.0}) {
    scenes::set_creepage(problem, mu, 5e-4, 2e-4, 1e-4);
    const ContactResult result = solve(problem);
    EXPECT_TRUE(result.certified()) << mu << ' ' << result.trust.solver_note;
    EXPECT_GT(result.effort.outer_iterations, 1);
  }
}

/// A turn by pi about x makes the lower body the upper one. What acted on the upper body acts on the lower
/// one now: with the opposite creepage Fx is the opposite; the pressure and the approach stay.
TEST(Coupling, BodiesMayExchangePlaces) {
  const Material soft{23000, 0.31}, hard{82000, 0.1};
  ContactProblem problem = roller(soft, hard, 24), turned = roller(hard, soft, 24);
  scenes::set_creepage(problem, 0.3, 4e-4, 0, 0);
  scenes::set_creepage(turned, 0.3, -4e-4, 0, 0);
  const ContactResult a = solve(problem), b = solve(turned);
  ASSERT_TRUE(a.certified() && b.certified());
  EXPECT_NEAR(a.totals.Fx, -b.totals.Fx, 1e-5 * std::abs(a.totals.Fx));
  EXPECT_GT(std::abs(a.totals.Fx), 0.02 * problem.force);
  EXPECT_NEAR(a.totals.approach, b.totals.approach, 1e-6 * a.totals.approach);
  for (std::size_t i = 0; i < a.pn.size(); ++i)
    EXPECT_NEAR(a.pn[i], b.pn[i], 1e-4 * a.patches[0].pmax) << i;
}

TEST(Coupling, EqualMaterialsNeedOneTurn) {
  ContactProblem problem = roller(scenes::steel, scenes::steel, 24);
  scenes::set_creepage(problem, 0.3, 5e-4, 2e-4, 1e-4);
  const ContactResult rolling = solve(problem);
  ASSERT_TRUE(rolling.certified());
  EXPECT_EQ(rolling.effort.outer_iterations, 1);
  problem.tangential = false;
  const ContactResult frictionless = solve(problem);
  EXPECT_NEAR(rolling.totals.approach, frictionless.totals.approach, 1e-9 * rolling.totals.approach);
}

/// Shear moduli that differ by 1e-8 couple above rounding, and the bound of what shear does tells that a
/// second outer iteration would change nothing that the tolerance sees. The certificate knows of the
/// coupling.
TEST(Coupling, BelowTheToleranceNeedsOneTurn) {
  const auto rolling = [](double difference, double inclination) {
    Material upper = scenes::steel;
    upper.shear_modulus *= 1 + difference;
    ContactProblem problem = roller(scenes::steel, upper, 24);
    for (ContactRow& row : problem.rows)
      row.delta = inclination;
    scenes::set_creepage(problem, 0.3, 5e-4, 2e-4, 1e-4);
    EXPECT_EQ(contact::numbers_couple(problem.numbers), difference > 0);
    return solve(problem);
  };
  for (const auto& [difference, inclination] : {std::pair{1e-8, 0.0}, {0.0, 1e-8}, {1e-8, 1e-8}}) {
    const ContactResult weak = rolling(difference, inclination);
    EXPECT_EQ(weak.effort.outer_iterations, 1) << difference << ' ' << inclination;
    EXPECT_TRUE(weak.certified());
    EXPECT_LT(weak.trust.certificate.worst(), 1e-7);
  }
  for (const auto& [difference, inclination] : {std::pair{1e-4, 0.0}, {0.0, 1e-4}}) {
    const ContactResult stronger = rolling(difference, inclination);
    EXPECT_GT(stronger.effort.outer_iterations, 1) << difference << ' ' << inclination;
    EXPECT_TRUE(stronger.certified());
  }
}

/// The bound against sums: whatever the shear tractions, they move the surfaces apart by no more than this
/// share of what a pressure as large does, and in a corner of the grid they nearly do.
TEST(Coupling, NoShearMovesTheSurfacesApartByMoreThanItsBound) {
  const ContactGrid grid = roller(scenes::steel, scenes::steel, 12).grid;
  const InfluenceNumbers a = scenes::pair({23000, 0.31}, {82000, 0.1}, grid);
  double low = 0, high = 1;
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (low + high);
    (contact::shear_moves_normal(a, middle) ? low : high) = middle;
  }
  double largest = 0;
  for (const double angle : {0.0, 0.8, 1.57, 2.4}) {
    double by_shear = 0, by_pressure = 0;
    for (int is = 0; is < grid.ms; ++is)
      for (int ix = 0; ix < grid.mx; ++ix) { // on the element in the corner
        by_shear += std::cos(angle) * a.at(ix, 0, component_n, is, component_x) +
                    std::sin(angle) * a.at(ix, 0, component_n, is, component_s);
        by_pressure += a.at(ix, 0, component_n, is, component_n);
      }
    largest = std::max(largest, std::abs(by_shear) / by_pressure);
  }
  EXPECT_LT(largest, high);
  EXPECT_GT(largest, 0.5 * high);
}

/// Bentall and Johnson 1967: dissimilar rollers in free rolling creep by themselves; held at zero creepage
/// they transmit a force, whose sign is that of the creepage they would take. The softer body below.
TEST(Coupling, FreeRollingOfUnlikeBodiesIsNotFreeOfForce) {
  ContactProblem problem = roller({23000, 0.31}, {82000, 0.28}, 24);
  scenes::set_creepage(problem, 0.3, 0, 0, 0);
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified()) << result.trust.solver_note;
  ContactProblem exchanged = roller({82000, 0.28}, {23000, 0.31}, 24);
  scenes::set_creepage(exchanged, 0.3, 0, 0, 0);
  const ContactResult other = solve(exchanged);
  ASSERT_TRUE(other.certified());
  EXPECT_GT(std::abs(result.totals.Fx), 1e-3 * problem.force);
  EXPECT_NEAR(result.totals.Fx, -other.totals.Fx, 1e-5 * std::abs(result.totals.Fx));
  EXPECT_NEAR(result.totals.Fy, 0, 1e-6 * problem.force);
}

struct Curved : testing::TestWithParam<double> {};

/// Strips bent through 70 degrees and more: force balance, certificate, and the force at the approach found.
TEST_P(Curved, ConvergesAndBalances) {
  for (const double mu : {0.1, 0.3, 0.6}) {
    ContactProblem problem = roller(scenes::steel, scenes::steel, 32);
    for (double& h : problem.gap)
      h *= 0.3;
    problem.force = 30000;
    scenes::bend(problem, GetParam());
    scenes::rotate_numbers(problem);
    scenes::set_creepage(problem, mu, 4e-4, 3e-4, 3e-4);
    const ContactResult result = solve(problem);
    ASSERT_TRUE(result.certified()) << mu << ' ' << result.trust.solver_note
                                    << result.trust.certificate.worst();
    EXPECT_NEAR(result.totals.Fz, 30000, 1e-6 * 30000);
    EXPECT_GT(result.effort.outer_iterations, 1);
    problem.load = LoadKind::approach;
    problem.approach = result.totals.approach;
    const ContactResult again = solve(problem);
    ASSERT_TRUE(again.certified()) << again.trust.solver_note;
    EXPECT_NEAR(again.totals.Fz, result.totals.Fz, 1e-5 * result.totals.Fz);
    EXPECT_NEAR(again.totals.Fx, result.totals.Fx, 1e-5 * result.totals.Fz);
    EXPECT_NEAR(again.totals.Fy, result.totals.Fy, 1e-5 * result.totals.Fz);
  }
}

INSTANTIATE_TEST_SUITE_P(Radii, Curved, testing::Values(9.8, 7.0, -9.8));

/// Every number carried along to other frames describes the same bodies: tilting the whole problem by an
/// angle changes nothing in the local frames when the approach is tilted with it.
TEST(Coupling, TiltedProblemIsTheSameProblem) {
  ContactProblem problem = roller({23000, 0.31}, {82000, 0.1}, 20);
  scenes::set_creepage(problem, 0.3, 5e-4, 2e-4, 1e-4);
  problem.load = LoadKind::approach;
  problem.approach = 0.03;
  const ContactResult flat = solve(problem);
  const double delta = -60 * std::numbers::pi / 180;
  for (ContactRow& row : problem.rows)
    row.delta = delta;
  problem.approach = 0.03 / std::cos(delta);
  const ContactResult tilted = solve(problem);
  ASSERT_TRUE(flat.certified() && tilted.certified());
  EXPECT_NEAR(tilted.patches[0].fn, flat.totals.Fz, 1e-6 * flat.totals.Fz);
  EXPECT_NEAR(tilted.totals.Fz, flat.totals.Fz * std::cos(delta) + flat.totals.Fy * std::sin(delta),
              1e-6 * flat.totals.Fz);
  EXPECT_NEAR(tilted.totals.Fy, flat.totals.Fy * std::cos(delta) - flat.totals.Fz * std::sin(delta),
              1e-6 * flat.totals.Fz);
}

} // namespace
} // namespace bem_contact
