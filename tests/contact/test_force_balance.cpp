#include "bem_contact/contact/coupled/force_balance.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "tests/contact/scenes.hpp"

#include <cmath>
#include <functional>
#include <gmock/gmock.h>
#include <numeric>

namespace bem_contact {
namespace {

using ::testing::HasSubstr;

/// How many looks until the sum is the force; 0: not within 60.
int looks(double force, double start, const std::function<double(double)>& borne) {
  contact::ForceBalance balance(force);
  double pressed = start;
  for (int k = 1; k <= 60; ++k) {
    if (std::abs(borne(pressed) - force) < 1e-9 * force)
      return k;
    pressed = balance.next(pressed, borne(pressed));
  }
  return 0;
}

TEST(ForceBalance, AShareThatStaysIsFoundAtOnce) {
  for (const double share : {0.3, 0.8, 1.0, 1.7, 5.0})
    EXPECT_EQ(looks(1000, 1000, [&](double n) { return share * n; }), share == 1 ? 1 : 2) << share;
}

TEST(ForceBalance, SmoothSumsTakeFewLooks) {
  EXPECT_LE(looks(1000, 1000, [](double n) { return n - 400 * std::tanh(n / 900); }), 8);
  EXPECT_LE(looks(1000, 5000, [](double n) { return n + 300 * std::sqrt(n / 700); }), 8);
  EXPECT_LE(looks(1, 1, [](double n) { return n * n * n / 50; }), 14);
}

TEST(ForceBalance, ASumThatIsNotMonotoneOrHasCornersIsFound) {
  EXPECT_GT(looks(1000, 100, [](double n) { return n + 600 * std::sin(n / 150); }), 0);
  EXPECT_GT(looks(1000, 3000, [](double n) { return n < 2000 ? 0.1 * n : 200 + 1.5 * (n - 2000); }), 0);
  EXPECT_GT(looks(1000, 1000, [](double n) { return n < 1500 ? -0.5 * n : -750 + 2 * (n - 1500); }), 0);
}

/// Next to a start that is nearly the solution. On a steep flange shear bears against most of the pressure
/// force and does not grow with it in proportion: the proportion would lead far away.
TEST(ForceBalance, AStartIsFollowedWithoutOvershoot) {
  const auto borne = [](double n) { return 3400 + 0.43 * (n - 64000); }; // 0.05 n at the solution
  for (const double off : {0.97, 1.03}) {
    contact::ForceBalance balance(3400);
    const double pressed = balance.start(off * 64000, borne(off * 64000));
    EXPECT_NEAR(pressed, 64000, 0.1 * std::abs(off - 1) * 64000);
    EXPECT_NEAR(balance.next(pressed, borne(pressed)), 64000, 0.01 * std::abs(off - 1) * 64000);
  }
  contact::ForceBalance level(3400); // a share of 0.9 stays
  EXPECT_NEAR(level.start(3000, 2700), 3400 / 0.9, 1e-9);
  EXPECT_EQ(level.start(1, 1e5), 3400 / contact::largest_start_share);
  EXPECT_EQ(level.start(1e6, -1e6), contact::largest_force_ratio * 3400);
}

/// Where the first sums are off by more than what is asked for in the end, their brackets are as well.
TEST(ForceBalance, EarlySumsNeedNotBePrecise) {
  for (const double error : {-3e-5, 3e-5}) {
    int look = 0;
    EXPECT_GT(looks(1000, 1000,
                    [&](double n) { return 0.06 * n * (1 + (++look < 12 ? error : 0)) + 1e-9 * n * n; }),
              0)
        << error;
  }
}

TEST(ForceBalance, LooksNoFurtherThanTheMost) {
  contact::ForceBalance balance(1000);
  double pressed = 1000;
  for (int k = 0; k < 10; ++k)
    pressed = balance.next(pressed, -0.2 * pressed);
  EXPECT_EQ(pressed, contact::largest_force_ratio * 1000);
}

/// Elements on a plane inclined by `delta` that all slip along s: p_s = mu p_n, up or down the plane.
ContactProblem sliding(double delta, double friction, double eta) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 20, 20, 0.5, 0.5, 1e-3, 2e-3);
  for (ContactRow& row : problem.rows) {
    row.position = {row.s * std::cos(delta), row.s * std::sin(delta)};
    row.delta = delta;
  }
  scenes::set_creepage(problem, friction, 0, eta, 0);
  problem.force = 3000;
  return problem;
}

double pressure_force(const ContactProblem& problem, const ContactResult& result) {
  return std::accumulate(result.pn.begin(), result.pn.end(), 0.0) * problem.element_area();
}

TEST(ForceBalance, OnAPlaneThatAllSlipsOnItIsTheClosedForm) {
  for (const double mu : {0.1, 0.3, 0.5})
    for (const double eta : {-5.0, 5.0}) // elastic slip hardly turns it
      for (const double degrees : {-70.0, -40.0, 20.0, 60.0}) {
        const double delta = degrees * std::numbers::pi / 180;
        const double share = std::cos(delta) + std::copysign(mu, eta) * std::sin(delta);
        if (share < 0.05)
          continue;
        const ContactProblem problem = sliding(delta, mu, eta);
        const ContactResult result = solve(problem);
        ASSERT_TRUE(result.certified())
            << mu << ' ' << eta << ' ' << degrees << ' ' << result.trust.solver_note;
        EXPECT_NEAR(pressure_force(problem, result), problem.force / share, 1e-6 * problem.force / share);
        EXPECT_LE(result.effort.outer_iterations, 5) << mu << ' ' << eta << ' ' << degrees;
      }
}

/// mu tan(delta) > 1, the wheel dragged down: it wedges itself, whatever presses it.
TEST(ForceBalance, AWheelThatWedgesItselfIsRefused) {
  const ContactProblem problem = sliding(-70 * std::numbers::pi / 180, 0.5, 0.2);
  try {
    solve(problem);
    FAIL() << "solved";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("No pressure balances the vertical force"));
    EXPECT_THAT(error.what(), HasSubstr("3000 N are prescribed"));
    EXPECT_THAT(error.what(), HasSubstr("an approach in place of the force"));
  }
  ContactProblem by_approach = problem; // has an answer: a vertical force that lifts
  by_approach.load = LoadKind::approach;
  by_approach.approach = 0.02;
  const ContactResult result = solve(by_approach);
  EXPECT_TRUE(result.certified());
  EXPECT_LT(result.totals.Fz, 0);
}

} // namespace
} // namespace bem_contact
