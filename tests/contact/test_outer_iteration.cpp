#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/coupled/anderson.hpp"
#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/coupled/solve_coupled.hpp"
#include "bem_contact/contact/coupled/start.hpp"
#include "bem_contact/contact/coupled/tolerance_schedule.hpp"
#include "bem_contact/contact/grid/larger_elements.hpp"
#include "bem_contact/contact/slip_step.hpp"
#include "bem_contact/contact/solve.hpp"
#include "tests/contact/scenes.hpp"

#include <Eigen/LU>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

/// The pieces of the outer iteration, one by one.
namespace bem_contact {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using ::testing::HasSubstr;

TEST(Anderson, FindsTheFixedPointOfALinearMapInAsManyStepsAsItHasDimensions) {
  MatrixXd a(3, 3);
  a << 0.9, 0.2, 0, 0, 0.5, 0.1, 0.1, 0, -0.7;
  const VectorXd b = VectorXd::LinSpaced(3, 1, 3);
  const VectorXd exact = (MatrixXd::Identity(3, 3) - a).lu().solve(b);
  contact::Anderson anderson;
  VectorXd v = VectorXd::Zero(3);
  for (int k = 0; k < 5; ++k)
    v = anderson.next(v, a * v + b - v);
  EXPECT_LT((v - exact).norm(), 1e-9 * exact.norm());
}

TEST(Anderson, TakesAShortStepIfTheResidualGrowsFarBeyondTheBest) {
  contact::Anderson anderson;
  const VectorXd one = VectorXd::Ones(2);
  anderson.next(one, one);
  const VectorXd large = 2 * contact::anderson_restart * one;
  EXPECT_EQ(anderson.next(one, large), one + contact::anderson_short_step * large);
}

TEST(ToleranceSchedule, TightensWithTheChangeAndSettlesOnlyAtTheToleranceAsked) {
  contact::ToleranceSchedule schedule(1e-8, true);
  EXPECT_EQ(schedule.now(), contact::loose_tolerance);
  EXPECT_FALSE(schedule.is_settled(1e-9)); // close, but solved loosely
  EXPECT_TRUE(schedule.is_close(1e-9));
  schedule.tighten(1e-4, 1, 1);
  EXPECT_DOUBLE_EQ(schedule.now(), contact::tolerance_of_change * 1e-4);
  schedule.tighten(contact::final_tolerance_ratio / contact::tolerance_of_change * 1.1e-8, 1, 1);
  EXPECT_GT(schedule.now(), contact::final_tolerance_ratio * 1e-8);
  schedule.tighten(contact::final_tolerance_ratio / contact::tolerance_of_change * 0.9e-8, 1,
                   1); // may be the last
  EXPECT_EQ(schedule.now(), 1e-8);
  schedule.tighten(2e-5, 1e-2, 1); // too much of this change may be left
  EXPECT_DOUBLE_EQ(schedule.now(), contact::tolerance_of_change * 2e-5);
  schedule.tighten(2e-5, 1e-3, 1);
  EXPECT_EQ(schedule.now(), 1e-8);
  schedule.tighten(1e-12, 1, 1);
  EXPECT_EQ(schedule.now(), 1e-8);
  EXPECT_TRUE(schedule.is_settled(1e-8));
  EXPECT_FALSE(schedule.is_settled(1e-6));
  schedule.tighten(1e-12, 1, 0.1); // the force is a tenth of the pressure's
  EXPECT_DOUBLE_EQ(schedule.now(), 1e-9);
  EXPECT_EQ(contact::ToleranceSchedule(1e-8, false).now(), 1e-8);
}

TEST(Capacity, ForcesThatFrictionCannotCarryAreRefused) {
  ContactProblem problem;
  problem.force_x = 300;
  problem.force_s = 400;
  contact::FoundCreepage creepage;
  EXPECT_NO_THROW(contact::require_capacity(problem, creepage));
  creepage.capacity = 450;
  creepage.beyond = true;
  try {
    contact::require_capacity(problem, creepage);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("|F| = 500 N where friction carries less"));
    EXPECT_THAT(error.what(), HasSubstr("450 N"));
  }
  creepage = {.reached = false, .capacity = 600};
  EXPECT_NO_THROW(contact::require_capacity(problem, creepage)); // the result says so
  problem.kinetic = 0.8;
  EXPECT_THROW(contact::require_capacity(problem, creepage), InputError);
}

TEST(LargerElements, KeepAForceAndLeaveOutTheRowFartherFromTheContact) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 7, 9, 0.5, 0.4, 1e-3, 1e-3);
  problem.force = 100;
  std::vector<double> pn(problem.grid.size(), 0.0);
  pn[7 * 7 + 5] = 8; // near the end of both
  const contact::LargerElements larger(problem.grid, pn);
  const ContactGrid coarse = larger.grid();
  EXPECT_EQ(coarse.mx, 3);
  EXPECT_EQ(coarse.ms, 4);
  EXPECT_EQ(coarse.dx, 1);
  EXPECT_DOUBLE_EQ(coarse.x(0), 0.5 * (problem.grid.x(1) + problem.grid.x(2)));
  const std::vector<double> mean = larger.mean(pn);
  EXPECT_DOUBLE_EQ(std::accumulate(mean.begin(), mean.end(), 0.0), 2.0);
  EXPECT_DOUBLE_EQ(mean[3 * 3 + 2], 2.0);
}

/// A uniform pressure on a large element displaces it as on the elements that it joins, on average. All
/// numbers, of both forms, are random: sums over offsets may be anything.
TEST(LargerElements, TheirInfluenceNumbersAreMeansOverElements) {
  for (const bool translational : {true, false}) {
    ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 6, 7, 0.5, 0.4, 1e-3, 1e-3);
    InfluenceNumbers& fine = problem.numbers;
    if (!translational)
      fine = with_every_pair_of_rows(fine);
    for (std::size_t i = 0; i < fine.values.size(); ++i)
      fine.values[i] = std::sin(1.0 + 37.0 * static_cast<double>(i));
    std::vector<double> pn(problem.grid.size(), 0.0);
    pn.back() = 1; // the first row is left out
    const InfluenceNumbers coarse = contact::LargerElements(problem.grid, pn).numbers(fine, false);
    ASSERT_EQ(coarse.rows, 3);
    ASSERT_EQ(coarse.offsets, 3 + rolling_columns);
    ASSERT_EQ(coarse.translational, translational);
    for (int m = 0; 2 * m + 1 < fine.offsets; ++m)
      for (const auto& [row_i, row_j] : coarse.stored_rows())
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            double mean = 0;
            for (int a = 0; a < 4; ++a)
              for (int b = 0; b < 4; ++b) {
                const int ahead = 2 * m + a % 2 - b % 2;
                mean += (ahead < 0 ? parity(i, j) : 1) / 4.0 *
                        fine.at(std::abs(ahead), 1 + 2 * row_i + a / 2, i, 1 + 2 * row_j + b / 2, j);
              }
            ASSERT_NEAR(coarse.at(m, row_i, i, row_j, j), mean, 1e-13) << m << row_i << row_j << i << j;
          }
  }
}

TEST(Start, AGuessWithoutPressureIsIgnored) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 8, 8, 0.5, 0.5, 1e-3, 1e-3);
  problem.force = 100;
  StartingPoint guess;
  guess.px = guess.ps = guess.pn = std::vector<double>(problem.grid.size(), 0.0);
  contact::ContactOperators operators;
  WorkBudget work;
  EXPECT_EQ(contact::start(problem, {.start = &guess}, operators, work).normal.p.size(), 0);
  guess.pn[27] = 3;
  guess.pn[28] = -1;
  const contact::Solution start = contact::start(problem, {.start = &guess}, operators, work);
  EXPECT_EQ(start.normal.p.sum(), 3);
  EXPECT_EQ(std::ranges::count(start.normal.sides, contact::NormalSide::touching), 1);
  EXPECT_EQ(work.used(), 0);
}

TEST(Coupling, IsFoundInTheInfluenceNumbers) {
  ContactProblem problem = scenes::flat(scenes::steel, scenes::steel, 6, 6, 0.5, 0.5, 1e-3, 1e-3);
  EXPECT_FALSE(contact::numbers_couple(problem.numbers)); // equal bodies
  problem.numbers = scenes::pair(scenes::steel, {40000, 0.2}, problem.grid);
  EXPECT_TRUE(contact::numbers_couple(problem.numbers));
}

} // namespace
} // namespace bem_contact
