#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/history.hpp"
#include "tests/contact/scenes.hpp"

#include <gmock/gmock.h>

namespace bem_contact {
namespace {

ContactProblem rolling(int n) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, n, n, 12.0 / n, 12.0 / n, 1e-3, 1.4e-3);
  problem.force = 15000;
  return problem;
}

TEST(FrictionLaw, EachRowHasItsOwnCoefficient) {
  ContactProblem problem = rolling(20);
  scenes::set_creepage(problem, 0.3, 0.03, 0, 0);
  for (const ContactRow& row : problem.rows)
    problem.friction_rows.push_back(row.s < 0 ? 0.1 : 0.4);
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified()) << result.trust.solver_note;
  double expected = 0;
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double bound = problem.friction_of(i / problem.grid.mx) * result.pn[i];
    EXPECT_NEAR(std::hypot(result.px[i], result.ps[i]), bound, 1e-6 * 0.4 * result.patches[0].pmax);
    expected += bound * problem.element_area();
  }
  EXPECT_NEAR(result.totals.Fx, expected, 0.001 * expected);
  EXPECT_NEAR(expected, 0.25 * problem.force, 1e-3 * problem.force) << "half of the patch with each";
}

TEST(FrictionLaw, OneCoefficientForAllRowsIsTheSame) {
  ContactProblem problem = rolling(26); // 40 elements of the companion in contact: it is estimated
  scenes::set_creepage(problem, 0.3, 6e-4, 3e-4, 2e-4);
  const ContactResult one = solve(problem);
  problem.friction = 7;
  problem.friction_rows.assign(problem.grid.ms, 0.3);
  const ContactResult each = solve(problem);
  ASSERT_TRUE(one.certified() && each.certified());
  ASSERT_TRUE(one.trust.discretisation && each.trust.discretisation);
  EXPECT_NEAR(each.totals.Fx, one.totals.Fx, 1e-9 * one.totals.Fx);
  EXPECT_NEAR(each.trust.discretisation->tangential, one.trust.discretisation->tangential, 1e-9);
}

/// On a flange the forces jump with every element that starts to slip, and outer iterations begin with rough
/// tractions. What a rough solution leaves of slip tells no element's state.
TEST(FrictionLaw, SlipIsKineticOnAFlange) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 40, 40, 0.25, 0.25, 1e-3, 1e-3);
  scenes::bend(problem, 12);
  for (ContactRow& row : problem.rows)
    row.delta -= 0.7;
  problem.force = 2e4;
  problem.kinetic = 0.5;
  for (const double xi : {2e-3, 3e-3}) {
    scenes::set_creepage(problem, 0.5, xi, 2e-3, 0);
    const ContactResult result = solve(problem, scenes::without_estimate);
    EXPECT_TRUE(result.certified()) << xi << ' ' << result.trust.certificate.worst() << ' '
                                    << result.trust.solver_note;
    EXPECT_LT(result.effort.outer_iterations, 25) << xi;
  }
}

/// What sticks may carry mu p_n, what slips has kinetic mu p_n against it.
TEST(FrictionLaw, SlipIsKinetic) {
  ContactProblem problem = rolling(24);
  scenes::set_creepage(problem, 0.4, 7e-4, 2e-4, 1e-4);
  const ContactResult stronger = solve(problem);
  problem.kinetic = 0.75;
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified()) << result.trust.solver_note << result.trust.certificate.worst();
  problem.friction = 0.3;
  problem.kinetic = 1;
  const ContactResult weaker = solve(problem);
  EXPECT_GT(result.totals.Fx, weaker.totals.Fx);
  EXPECT_LT(result.totals.Fx, stronger.totals.Fx);
  int beyond_kinetic = 0;
  for (int i = 0; i < problem.grid.size(); ++i) {
    const double shear = std::hypot(result.px[i], result.ps[i]), pmax = result.patches[0].pmax;
    EXPECT_LE(shear, 0.4 * result.pn[i] + 1e-6 * pmax);
    if (result.state[i] == ElementState::slip) {
      EXPECT_NEAR(shear, 0.3 * result.pn[i], 1e-6 * pmax);
    } else
      beyond_kinetic += shear > 0.301 * result.pn[i] && result.pn[i] > 0;
  }
  EXPECT_GT(beyond_kinetic, 0);
  EXPECT_GT(result.patches[0].adhesion, weaker.patches[0].adhesion - 1);
}

TEST(FrictionLaw, KineticFullSlip) {
  ContactProblem problem = rolling(16);
  problem.kinetic = 0.5;
  scenes::set_creepage(problem, 0.4, 0, -0.03, 0);
  const ContactResult result = solve(problem);
  ASSERT_TRUE(result.certified()) << result.trust.solver_note;
  EXPECT_NEAR(result.totals.Fy, -0.2 * problem.force, 1e-3 * problem.force);
}

TEST(FrictionLaw, WrongOnesAreRefused) {
  ContactProblem problem = rolling(8);
  scenes::set_creepage(problem, 0.4, 1e-3, 0, 0);
  for (const double kinetic : {0.0, -1.0, 1.5, std::nan("")}) {
    problem.kinetic = kinetic;
    EXPECT_THROW(solve(problem), InputError);
  }
  problem.kinetic = 1;
  problem.friction_rows = {0.3, 0.3};
  EXPECT_THROW(solve(problem), InputError);
  problem.friction_rows.assign(8, -0.3);
  EXPECT_THROW(solve(problem), InputError);
  problem.friction_rows.assign(8, 0.0);
  problem.force_x = 10;
  EXPECT_THROW(solve(problem), InputError);
}

TEST(FrictionLaw, DisplacementsAndPowerBelongToTheResult) {
  ContactProblem problem = scenes::flat({23000, 0.31}, scenes::steel, 20, 20, 0.6, 0.6, 1e-3, 1.4e-3);
  problem.force = 15000;
  scenes::set_creepage(problem, 0.3, 7e-4, 2e-4, 1e-4);
  const ContactResult result = solve(problem, {.estimate_discretisation = false, .displacements = true});
  ASSERT_TRUE(result.certified());
  const Displacements& u = result.displacements;
  const ContactResult without = solve(problem, {.estimate_discretisation = false});
  EXPECT_TRUE(without.displacements.un.empty());
  EXPECT_EQ(without.trust.certificate.worst(), result.trust.certificate.worst());
  const std::vector<double> power = friction_work_density(result);
  for (int i = 0; i < problem.grid.size(); ++i) {
    EXPECT_NEAR(result.deformed_distance[i], problem.gap[i] - result.totals.approach - u.un[i], 1e-9);
    EXPECT_GE(power[i], -1e-9) << "slip never feeds power in";
    if (result.state[i] == ElementState::slip) {
      const double slip = std::hypot(result.slip_x[i], result.slip_s[i]);
      // Waves that end here bring some more.
      EXPECT_GE(power[i], 0.3 * result.pn[i] * slip - 1e-6 * 0.3 * result.patches[0].pmax * 7e-4);
    }
    if (i % problem.grid.mx > 0 && i % problem.grid.mx + 2 < problem.grid.mx) {
      const double step = 1.5 * u.ux[i] - 2 * u.ux[i + 1] + 0.5 * u.ux[i + 2];
      if (result.pn[i] > 0) {
        EXPECT_NEAR(result.slip_x[i] * problem.grid.dx, problem.slip_x[i] * problem.grid.dx + step, 1e-10);
      }
    }
  }
}

} // namespace
} // namespace bem_contact
