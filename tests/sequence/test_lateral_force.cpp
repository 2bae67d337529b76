#include "bem_contact/sequence/lateral_force.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

std::vector<double> displacements(const LateralForce& force, double wanted) {
  std::vector<double> out;
  for (const LateralRoot& root : find_lateral_roots(force, sample_lateral_force(force, 0), wanted))
    out.push_back(root.lateral);
  return out;
}

TEST(LateralForce, EachBranchIsFound) {
  // A tread that falls, a flange that rises from 6.1 mm on and falls behind its steepest place at 8.6.
  const LateralForce force = [](double y) -> std::optional<double> {
    return -100 * y + (y > 6.1 ? 2e4 * (1 - std::pow(1 - (y - 6.1) / 2.5, 2)) : 0.0);
  };
  const std::vector<double> high = displacements(force, 5000);
  ASSERT_EQ(high.size(), 2u);
  for (const double y : high)
    EXPECT_NEAR(*force(y), 5000, 20); // to lateral_root_width
  EXPECT_EQ(displacements(force, 250).size(), 3u) << "tread, flange before and behind its steepest place";
  EXPECT_TRUE(displacements(force, 1e6).empty());
}

TEST(LateralForce, APeakBetweenTwoSamplesIsFound) {
  // Samples lie at multiples of 0.5 mm and reach 1000 - 62.5; the peak is at 3.25.
  const LateralForce peak = [](double y) -> std::optional<double> {
    return 1000 - 1000 * std::pow(y - 3.25, 2);
  };
  const std::vector<double> roots = displacements(peak, 990);
  ASSERT_EQ(roots.size(), 2u);
  EXPECT_NEAR(roots[0], 3.15, 2e-3);
  EXPECT_NEAR(roots[1], 3.35, 2e-3);
  EXPECT_TRUE(displacements(peak, 1001).empty());
}

TEST(LateralForce, WhereThereIsNoContactThereIsNoBranch) {
  const LateralForce gap = [](double y) -> std::optional<double> {
    return std::abs(y) < 1 ? std::nullopt : std::optional(y);
  };
  EXPECT_TRUE(displacements(gap, 0.0).empty()) << "the force does not pass zero anywhere";
  EXPECT_EQ(displacements(gap, 3.2).size(), 1u);
}

TEST(LateralForce, TheForceIsMetFromAStartNearby) {
  int calls = 0;
  const LateralForce steep = [&](double y) -> std::optional<double> {
    ++calls;
    return 2e5 * y + 1e4 * std::sin(20 * y);
  };
  const double y = solve_lateral_force(steep, 1e4, {0.1, 2.1e5}, 0.1);
  EXPECT_NEAR(*steep(y), 1e4, 0.1);
  EXPECT_LE(calls, 12);
}

TEST(LateralForce, AJumpOverTheForceIsNoSolution) {
  const LateralForce jump = [](double y) -> std::optional<double> { return y < 0.1 ? 0.0 : 1e4 + y; };
  try {
    solve_lateral_force(jump, 5e3, {0.05, 1e5}, 1);
    FAIL() << "there is no such displacement";
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("No lateral displacement with a lateral force of 5000 N was found"));
  }
}

SceneFile rolling(double lateral, const std::string& more = "") {
  return parse_scene_file(
      fmt::format("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.lateral = {}\n"
                  "load.force = 1e5\nsolver.model = \"halfspace\"\ngrid.dx = 1.0\ngrid.ds = 0.6\n{}",
                  lateral, more));
}

TEST(PrescribedLateralForce, FindsThePositionThatBearsIt) {
  const SceneResult there = Sequence().solve(rolling(6.62));
  Sequence sequence;
  const SceneResult found =
      sequence.solve(rolling(6.5, fmt::format("load.force_y = {:.17g}\n", there.result.Fy)));
  ASSERT_TRUE(found.found_lateral && found.result.certificate.holds());
  EXPECT_NEAR(found.found_lateral->lateral, 6.62, 1e-5);
  EXPECT_NEAR(found.result.Fy, there.result.Fy, 0.2);
  EXPECT_NEAR(largest_pressure(found.result), largest_pressure(there.result),
              1e-3 * largest_pressure(there.result));
  // The next one on the same branch: rough solutions are there already.
  const SceneResult next = sequence.solve(rolling(6.5, "load.force_y = 2e4\n"));
  EXPECT_NEAR(next.result.Fy, 2e4, 0.2);
  EXPECT_LT(*next.lateral, 6.62);
}

TEST(PrescribedLateralForce, TheNearestBranchIsTakenAndTheOthersAreSaid) {
  const SceneResult flange = Sequence().solve(rolling(7, "motion.frictionless = true\nload.force_y = 2e5\n"));
  ASSERT_TRUE(flange.found_lateral);
  ASSERT_FALSE(flange.found_lateral->others.empty()) << "behind the steepest place of the flange";
  const double other = flange.found_lateral->others.front();
  const SceneResult beyond =
      Sequence().solve(rolling(other, "motion.frictionless = true\nload.force_y = 2e5\n"));
  EXPECT_NEAR(beyond.found_lateral->lateral, other, 0.1);
  EXPECT_NEAR(beyond.result.Fy, 2e5, 0.3);
}

TEST(PrescribedLateralForce, ALeftWheelIsTheMirrorImage) {
  const SceneResult right = Sequence().solve(rolling(6.5, "load.force_y = 3e4\n"));
  const SceneResult left = Sequence().solve(rolling(-6.5, "position.side = \"left\"\nload.force_y = 3e4\n"));
  EXPECT_NEAR(*left.lateral, -*right.lateral, 1e-7);
  EXPECT_NEAR(largest_pressure(left.result), largest_pressure(right.result), 1e-3);
}

TEST(PrescribedLateralForce, WhatCannotBeIsRefused) {
  EXPECT_THAT(message_of([] { Sequence().solve(rolling(0, "load.force_y = 1e9\n")); }),
              AllOf(HasSubstr("No lateral displacement gives a lateral force of 1e+09 N"),
                    HasSubstr("the force on the rail is between")));
  EXPECT_THAT(message_of([] { rolling(0, "load.force_y = 1e4\nmotion.kind = \"transient\"\n"); }),
              HasSubstr("another one at each step"));
  EXPECT_THAT(message_of([] {
                parse_scene_file("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.approach = 0.1\n"
                                 "load.force_y = 1e4\n");
              }),
              HasSubstr("load.force is not given"));
}

} // namespace
