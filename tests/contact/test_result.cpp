#include "bem_contact/contact/totals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

/// Elements of 2 x 0.5 mm; three columns and four rows, and a pressure on each element.
struct Pressed {
  ContactProblem problem;
  ContactResult result;

  explicit Pressed(std::vector<double> pn) {
    problem.grid = {.mx = 3, .ms = 4, .dx = 2, .ds = 0.5};
    problem.numbers.dx = 2;
    problem.friction_rows = {0.1, 0.2, 0.3, 0.4};
    for (int row = 0; row < 4; ++row)
      problem.rows.push_back({.s = 0.5 * row, .position = {0.5 * row, 0}});
    problem.gap.assign(12, 0.0);
    for (const double p : pn)
      result.state.push_back(p > 0 ? ElementState::slip : ElementState::exterior);
    result.pn = std::move(pn);
  }
};

/// A result is certified only if each condition was checked.
TEST(ContactResult, ThatNobodyCheckedIsNotCertified) {
  EXPECT_FALSE(ContactResult().certified());
  ContactResult checked;
  checked.trust.certificate = Certificate::without_violation();
  EXPECT_TRUE(checked.certified());
  for (double Certificate::*condition :
       {&Certificate::pressure, &Certificate::penetration, &Certificate::complementarity,
        &Certificate::friction_cone, &Certificate::adhesion, &Certificate::slip_direction,
        &Certificate::force_balance}) {
    ContactResult missing = checked;
    missing.trust.certificate.*condition = Certificate().*condition;
    EXPECT_FALSE(missing.certified());
  }
}

/// Neighbours by a corner are one area; the area with the larger force is the first.
TEST(ContactResult, PatchesHaveTheirElements) {
  const Pressed p({1, 0, 0, //
                   0, 1, 0, //
                   0, 0, 0, //
                   5, 0, 0});
  EXPECT_THAT(patch_elements(p.problem, p.result),
              ElementsAre(UnorderedElementsAre(9), UnorderedElementsAre(0, 4)));
}

TEST(ContactResult, NoShearForceIsLargerThanTheFrictionBound) {
  Pressed p({1, 0, 0, //
             0, 1, 0, //
             0, 0, 0, //
             5, 0, 0});
  EXPECT_DOUBLE_EQ(friction_bound(p.problem, p.result), 0.1 * 1 + 0.2 * 1 + 0.4 * 5);
  p.problem.tangential = false;
  EXPECT_EQ(friction_bound(p.problem, p.result), 0);
}

TEST(ContactResult, WithoutSlipFrictionHasNoPower) {
  Pressed p(std::vector<double>(12, 1.0));
  p.result.px = p.result.ps = std::vector<double>(12, 0.1);
  set_totals(p.problem, p.result);
  EXPECT_EQ(p.result.totals.T_gamma, 0);
  p.result.slip_x.assign(12, 0.5);
  p.result.slip_s.assign(12, -0.2);
  set_totals(p.problem, p.result);
  EXPECT_NEAR(p.result.totals.T_gamma, 12 * (0.1 * 0.5 - 0.1 * 0.2), 1e-15);
}

} // namespace
