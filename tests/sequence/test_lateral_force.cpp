#include "bem_contact/sequence/asked_error.hpp"
#include "bem_contact/sequence/lateral/lateral_force.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/lateral/lateral_curve.hpp"
#include "bem_contact/sequence/lateral/lateral_search.hpp"
#include "bem_contact/sequence/lateral/settings.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/message.hpp"
#include "tests/sanitized.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

namespace {

using namespace bem_contact;
using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::ThrowsMessage;

/// All displacements that a search from 0 mm tells, ascending; the model's force is the rough one and
/// `missed`.
std::vector<double> displacements(const LateralForce& rough, double wanted, double missed = 0) {
  KnownLateralForces known;
  LateralSearch search({.wanted = wanted, .start = 0, .resultant = 1e4}, rough, known);
  const auto exact = [&](double y) {
    const std::optional<double> there = rough(y);
    return there ? std::optional(*there + missed) : std::nullopt;
  };
  const double found = search.find(exact);
  std::vector<double> out = search.describe(found, unknown_error).others;
  out.push_back(found);
  std::ranges::sort(out);
  return out;
}

/// A tread that falls, a flange that rises from 6.1 mm on and falls behind its steepest place at 8.6.
std::optional<double> tread_and_flange(double y) {
  return -100 * y + (y > 6.1 ? 2e4 * (1 - std::pow(1 - (y - 6.1) / 2.5, 2)) : 0.0);
}

TEST(LateralForce, EachBranchIsFound) {
  const std::vector<double> high = displacements(tread_and_flange, 5000);
  ASSERT_EQ(high.size(), 2u);
  for (const double y : high)
    EXPECT_NEAR(*tread_and_flange(y), 5000, 200);
  EXPECT_EQ(displacements(tread_and_flange, 250).size(), 3u)
      << "tread, flange before and behind its steepest place";
  EXPECT_THAT(message_of([] { displacements(tread_and_flange, 1e6); }),
              HasSubstr("from -12 to 12 mm the force on the rail is between"));
}

TEST(LateralForce, WhatRoughForcesMissDoesNotHideABranch) {
  // The rough forces of the tread end at -1200 and 1200 N.
  const LateralForce tread = [](double y) { return std::optional(-100 * y); };
  EXPECT_THAT(displacements(tread, 1500, 500), ElementsAre(DoubleNear(-10, 1e-3)));
  EXPECT_THAT(message_of([&] { displacements(tread, 1150, -100); }), HasSubstr("-1300 and 1100 N"));
}

TEST(LateralForce, APeakBetweenTwoSamplesIsFound) {
  const LateralForce peak = [](double y) -> std::optional<double> {
    return 1000 - 1000 * std::pow(y - 3.25, 2);
  };
  EXPECT_THAT(displacements(peak, 990), ElementsAre(DoubleNear(3.15, 0.02), DoubleNear(3.35, 0.02)));
  EXPECT_THAT(message_of([&] { displacements(peak, 1001); }), HasSubstr("and 1000 N"));
}

/// A second contact makes the largest force a kink: just below it there are two displacements.
TEST(LateralForce, AForceJustBelowAKinkIsFound) {
  const auto kink = [](double y) -> std::optional<double> { return 5000 - 4000 * std::abs(y - 5.3); };
  for (const double wanted : {4990.0, 4998.0, 4999.5}) {
    const std::vector<double> found = displacements(kink, wanted);
    EXPECT_TRUE(std::ranges::any_of(found, [&](double y) { return std::abs(*kink(y) - wanted) < 0.02; }))
        << wanted;
  }
}

TEST(LateralForce, WhereThereIsNoContactThereIsNoBranch) {
  const LateralForce gap = [](double y) -> std::optional<double> {
    return std::abs(y) < 1 ? std::nullopt : std::optional(y);
  };
  EXPECT_THAT(message_of([&] { displacements(gap, 0); }), HasSubstr("No lateral displacement gives"))
      << "the force does not pass zero anywhere";
  EXPECT_EQ(displacements(gap, 3.2).size(), 1u);
}

TEST(LateralForce, TheErrorOfTheForceIsAnErrorOfTheDisplacement) {
  KnownLateralForces known;
  const LateralForce tread = [](double y) { return std::optional(-100 * y); };
  LateralSearch search({.wanted = 30, .start = 0, .resultant = 1e4}, tread, known);
  const double found = search.find(tread);
  EXPECT_NEAR(found, -0.3, 1e-4);
  const LateralPosition said = search.describe(found, 40);
  EXPECT_NEAR(said.lateral.error, 0.4, 0.01);
  EXPECT_NEAR(said.slope, -100, 1);
  EXPECT_TRUE(std::isnan(search.describe(found, unknown_error).lateral.error));
}

TEST(LateralForce, AnExtremumHasTheWidthOverWhichItsForceIsAlike) {
  KnownLateralForces known;
  const LateralForce bowl = [](double y) { return std::optional(20 * y * y); };
  LateralSearch search({.wanted = 0.1, .start = 0.5, .resultant = 1e4}, bowl, known);
  const LateralPosition said = search.describe(search.find(bowl), 20);
  EXPECT_GT(said.lateral.error, 0.9) << "the force is 20 N at 1 mm";
  EXPECT_LT(said.lateral.error, 2.0);
  EXPECT_NEAR(std::abs(said.slope) * said.lateral.error, 20, 0.01) << "the slope that the error is made from";
}

TEST(LateralForce, ManyForcesOfOneSceneAreCheap) {
  int rough = 0, exact = 0;
  KnownLateralForces known;
  const auto search_for = [&](double wanted) {
    LateralSearch search(
        {.wanted = wanted, .start = 6.5, .resultant = 1e4},
        [&](double y) { return ++rough, tread_and_flange(y); }, known);
    return search.find([&](double y) { return ++exact, std::optional(*tread_and_flange(y) + 50); });
  };
  search_for(5000);
  EXPECT_LE(rough, 40);
  EXPECT_LE(exact, 8);
  rough = exact = 0;
  EXPECT_NEAR(*tread_and_flange(search_for(5500)), 5450, 0.02);
  EXPECT_LE(rough, 20) << "the samples are there already";
  EXPECT_LE(exact, 7);
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

/// A slope that misleads costs steps, and not the answer.
TEST(LateralForce, TheForceIsMetOnEitherSideOfTheStart) {
  const LateralForce tread = [](double y) { return std::optional(50 * y + 20 * std::sin(30 * y)); };
  for (const double slope : {60.0, -60.0}) {
    const double y = solve_lateral_force(tread, 0, {0.7, slope}, 1e-3);
    EXPECT_NEAR(*tread(y), 0, 1e-3);
    EXPECT_LT(std::abs(y), 0.7);
  }
}

TEST(LateralForce, AJumpOverTheForceIsNoSolution) {
  const LateralForce jump = [](double y) -> std::optional<double> { return y < 0.1 ? 0.0 : 1e4 + y; };
  EXPECT_THAT(
      [&] {
        solve_lateral_force(jump, 5e3, {0.05, 1e5}, 1);
      },
      ThrowsMessage<ConvergenceError>(
          AllOf(HasSubstr("No lateral displacement with a lateral force of 5000 N was found"),
                HasSubstr("5e+03 N are missing, and 1 N allowed"))));
  const LateralForce none = [](double) { return std::optional<double>(); };
  EXPECT_THAT(
      [&] {
        solve_lateral_force(none, 5e3, {0.05, 1e5}, 1);
      },
      ThrowsMessage<ConvergenceError>(HasSubstr("at 0.05 mm, where it should be, there is no solution")));
}

SceneFile rolling_at(double lateral, const std::string& more = "") {
  return parse_scene_file(
      fmt::format("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.lateral = {}\n"
                  "load.force = 1e5\nsolver.model = \"halfspace\"\ngrid.dx = 1.0\ngrid.ds = 0.6\n{}",
                  lateral, more));
}

TEST(PrescribedLateralForce, FindsThePositionThatBearsIt) {
  const SceneResult there = Sequence().solve(rolling_at(6.62));
  Sequence sequence;
  const SceneResult found =
      sequence.solve(rolling_at(6.5, fmt::format("load.force_y = {:.17g}\n", there.result.totals.Fy.value)));
  ASSERT_TRUE(found.motion.found_lateral && found.result.trust.certificate.holds());
  EXPECT_NEAR(found.motion.found_lateral->lateral, 6.62, 1e-5);
  EXPECT_NEAR(found.result.totals.Fy, there.result.totals.Fy, 0.2);
  EXPECT_NEAR(found.result.totals.pmax, there.result.totals.pmax, 1e-3 * there.result.totals.pmax);
  // The next one on the same branch: rough solutions are there already.
  const int rough = sequence.counts().rough;
  EXPECT_LE(rough, 40);
  const SceneResult next = sequence.solve(rolling_at(6.5, "load.force_y = 2e4\n"));
  EXPECT_LE(sequence.counts().rough - rough, 20);
  EXPECT_NEAR(next.result.totals.Fy, 2e4, 0.2);
  EXPECT_LT(*next.motion.lateral, 6.62);
}

/// A start that bears the force is the answer: one solution, and few rough ones for its error.
TEST(PrescribedLateralForce, AStartThatIsASolutionIsSolvedOnce) {
  for (const double lateral : {6.62, 0.0}) {
    const SceneResult there = Sequence().solve(rolling_at(lateral));
    Sequence sequence;
    const SceneResult again = sequence.solve(
        rolling_at(lateral, fmt::format("load.force_y = {:.17g}\n", there.result.totals.Fy.value)));
    ASSERT_TRUE(again.motion.found_lateral);
    EXPECT_EQ(again.motion.found_lateral->lateral, lateral);
    EXPECT_EQ(again.result.totals.Fy, there.result.totals.Fy);
    EXPECT_EQ(sequence.counts().solves, 1);
    EXPECT_LE(sequence.counts().rough, 20) << "12 mm in doubling steps to either side";
    EXPECT_NE(again.motion.found_lateral->slope, 0);
  }
}

/// Rough forces are uneven: beside the displacement they pass the force on the wrong side of where the model
/// is known.
TEST(PrescribedLateralForce, WhereRoughForcesMisleadTheOtherSideIsLookedAt) {
  const SceneResult found = Sequence().solve(parse_scene_file(
      "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nposition.lateral = 6.0\nload.force = 8e4\n"
      "load.force_y = 2e4\nmotion.friction = 0.3\nsolver.model = \"halfspace\"\n"
      "grid = { dx = 0.7071067811865476, ds = 0.5 }\n"));
  EXPECT_NEAR(found.result.totals.Fy, 2e4, 0.2);
  EXPECT_NEAR(found.motion.found_lateral->lateral, 6.497, 2e-3);
}

/// On a worn tread rough forces miss the model's by some thousandths: a force beyond their range is looked
/// for.
TEST(PrescribedLateralForce, AForceJustBelowTheRoughRangeIsFound) {
  const std::string rail = CONFORMAL_SOURCE_DIR "/data/bodies/worn_rail.txt";
  const auto solved = [&](const std::string& more) {
    return Sequence().solve(parse_scene_file(
        "rail.nominal = '60E1'\nwheel.profile = 'S1002'\nposition.rail_inclination = 0.05\n"
        "position.yaw = -0.0023063747156064135\nposition.roll = 0.0023984490507925945\n"
        "load.force = 19446.37674428483\nmotion.friction = 0.25988625637401036\nmotion.free_rolling = false\n"
        "motion.xi = -9.825598643268835e-05\nsolver.model = 'halfspace'\ngrid = { dx = 0.6, ds = 0.4 }\n"
        "rail.profile = '" +
        rail + "'\n" + more));
  };
  const double force = solved("position.lateral = -3.724526\n").result.totals.Fy;
  const SceneResult found =
      solved(fmt::format("position.lateral = -1.524219\nload.force_y = {:.9g}\n", force));
  EXPECT_NEAR(found.result.totals.Fy, force, 0.03);
}

/// From beside the greatest force of the flange, where one rough solution misses the model's by much.
TEST(PrescribedLateralForce, AForceNearTheGreatestIsFound) {
  const std::string more = "motion.frictionless = true\nposition.rail_inclination = 0.05\n";
  const double force = Sequence().solve(rolling_at(6.75, more)).result.totals.Fy;
  for (const double start : {6.65, 6.85}) {
    const SceneResult found =
        Sequence().solve(rolling_at(start, more + fmt::format("load.force_y = {:.17g}\n", force)));
    EXPECT_NEAR(found.result.totals.Fy, force, 0.3);
    EXPECT_NEAR(found.motion.found_lateral->lateral, 6.75, 1e-3);
  }
}

TEST(PrescribedLateralForce, ATreadWhoseForceSaysLittleIsFoundWithinTheStatedError) {
  NEEDS_NO_SANITIZER();
  // With friction, forces on the tread lie within 500 N over 6 mm, and each has an error of some ten newtons.
  const auto finer = [](double lateral) {
    SceneFile scene = rolling_at(lateral, "position.rail_inclination = 0.025\n");
    scene.grid.dx = 0.6, scene.grid.ds = 0.4;
    return scene;
  };
  for (const double lateral : {-5.0, -3.0, 0.0, 2.0}) {
    const double force = Sequence().solve(finer(lateral)).result.totals.Fy;
    for (const double away : {-0.1, 0.1}) {
      SceneFile asked = finer(lateral + away);
      asked.load.force_y = force;
      const SceneResult found = Sequence().solve(asked);
      ASSERT_TRUE(found.motion.found_lateral);
      EXPECT_NEAR(found.result.totals.Fy, force, 0.2);
      EXPECT_NEAR(found.motion.found_lateral->lateral, lateral, found.motion.found_lateral->lateral.error);
      EXPECT_GT(found.motion.found_lateral->lateral.error, lateral::unsure);
      EXPECT_LT(std::abs(found.motion.found_lateral->slope), 2000);
      EXPECT_THAT(found.warnings.texts(),
                  Contains(HasSubstr("load.force_y says little of the lateral displacement")));
    }
  }
}

TEST(PrescribedLateralForce, AnUnknownErrorOfTheForceIsWarnedOfToo) {
  const double force = Sequence().solve(rolling_at(0)).result.totals.Fy;
  const SceneResult found = Sequence().solve(rolling_at(0.1, fmt::format("load.force_y = {:.17g}\n", force)));
  ASSERT_TRUE(found.motion.found_lateral);
  ASSERT_TRUE(std::isnan(found.motion.found_lateral->lateral.error))
      << "the elements are too large for an estimate";
  EXPECT_THAT(found.warnings.texts(), Contains(HasSubstr("and its error is not known")));
}

TEST(PrescribedLateralForce, ATreadWithoutFrictionIsFoundWithoutAWarning) {
  const std::string more = "motion.frictionless = true\nposition.rail_inclination = 0.025\n";
  const SceneResult there = Sequence().solve(rolling_at(1, more));
  const SceneResult found = Sequence().solve(
      rolling_at(1.1, more + fmt::format("load.force_y = {:.17g}\n", there.result.totals.Fy.value)));
  ASSERT_TRUE(found.motion.found_lateral);
  EXPECT_NEAR(found.motion.found_lateral->lateral, 1, found.motion.found_lateral->lateral.error);
  EXPECT_LT(found.motion.found_lateral->lateral.error, 0.02);
  EXPECT_NEAR(found.motion.found_lateral->slope, 1960, 200);
  EXPECT_THAT(found.warnings.texts(), IsEmpty());
}

TEST(PrescribedLateralForce, TheLeastForceOfATreadIsFound) {
  const std::string more = "motion.frictionless = true\nposition.rail_inclination = 0.05\n";
  const SceneResult there = Sequence().solve(rolling_at(-1, more));
  for (const double start : {-1.1, -0.9}) {
    const SceneResult found = Sequence().solve(
        rolling_at(start, more + fmt::format("load.force_y = {:.17g}\n", there.result.totals.Fy.value)));
    ASSERT_TRUE(found.motion.found_lateral);
    EXPECT_NEAR(found.motion.found_lateral->lateral, -1, found.motion.found_lateral->lateral.error);
    EXPECT_THAT(found.warnings.texts(), Contains(HasSubstr("says little of the lateral displacement")));
  }
}

TEST(PrescribedLateralForce, TheNearestBranchIsTakenAndTheOthersAreSaid) {
  const SceneResult flange =
      Sequence().solve(rolling_at(7, "motion.frictionless = true\nload.force_y = 2e5\n"));
  ASSERT_TRUE(flange.motion.found_lateral);
  ASSERT_FALSE(flange.motion.found_lateral->others.empty()) << "behind the steepest place of the flange";
  const double other = flange.motion.found_lateral->others.front();
  const SceneResult beyond =
      Sequence().solve(rolling_at(other, "motion.frictionless = true\nload.force_y = 2e5\n"));
  EXPECT_NEAR(beyond.motion.found_lateral->lateral, other, 0.1);
  EXPECT_NEAR(beyond.result.totals.Fy, 2e5, 0.3);
}

TEST(PrescribedLateralForce, ALeftWheelIsTheMirrorImage) {
  const SceneResult right = Sequence().solve(rolling_at(6.5, "load.force_y = 3e4\n"));
  const SceneResult left =
      Sequence().solve(rolling_at(-6.5, "position.side = \"left\"\nload.force_y = 3e4\n"));
  EXPECT_NEAR(*left.motion.lateral, -*right.motion.lateral, 1e-7);
  EXPECT_NEAR(left.result.totals.pmax, right.result.totals.pmax, 1e-3);
}

/// What can be reached does not depend on what was wanted, and can be asked for.
TEST(PrescribedLateralForce, TheReachableRangeIsTheSameWhateverWasWanted) {
  const std::regex range("between about (\\S+) and (\\S+) N");
  const auto reached = [&](const std::string& wanted) {
    const std::string message = message_of([&] {
      Sequence().solve(rolling_at(0, "position.rail_inclination = 0.025\nload.force_y = " + wanted + "\n"));
    });
    std::smatch found;
    EXPECT_TRUE(std::regex_search(message, found, range)) << message;
    return found.empty() ? 0.0 : std::stod(found[2]);
  };
  const double most = reached("1e6");
  EXPECT_NEAR(reached("-3e5"), most, 0.02 * most);
  EXPECT_NEAR(reached("2e5"), most, 0.02 * most);
  EXPECT_NO_THROW(Sequence().solve(
      rolling_at(0, fmt::format("position.rail_inclination = 0.025\nload.force_y = {}\n", 0.98 * most))));
}

/// Where even the most elements that are tried miss the accuracy, the warning says so.
TEST(PrescribedLateralForce, TheWarningOfAMissedAccuracyNamesTheLimit) {
  SceneFile scene = rolling_at(6, "load.force_y = 1.6e5\n");
  scene.grid = {};
  scene.grid.accuracy = 0.02;
  const SceneResult found = Sequence().solve(scene);
  EXPECT_GT(asked_error(scene.grid, found.result), 0.02);
  EXPECT_THAT(found.warnings.texts(), Contains(HasSubstr("elements in contact; at most 1400 are tried)")));
}

/// The model bears the forces that a refusal names, where it says so. On the tread rough ones miss more than
/// it changes by.
TEST(PrescribedLateralForce, TheReachableForcesAreThoseOfTheModel) {
  const std::regex range("between about (\\S+) and (\\S+) N, at (\\S+) and (\\S+) mm");
  const std::string cant = "position.rail_inclination = 0.025\n";
  for (const double start : {-4.0, 0.0}) {
    const std::string message =
        message_of([&] { Sequence().solve(rolling_at(start, cant + "load.force_y = 3e5\n")); });
    std::smatch found;
    ASSERT_TRUE(std::regex_search(message, found, range)) << message;
    const double least = std::stod(found[1]), most = std::stod(found[2]);
    EXPECT_NEAR(Sequence().solve(rolling_at(std::stod(found[3]), cant)).result.totals.Fy, least, 1);
    EXPECT_NEAR(Sequence().solve(rolling_at(std::stod(found[4]), cant)).result.totals.Fy, most, 1e-3 * most);
    for (const double lateral : {-10, -8, -6, -4, 0, 2})
      EXPECT_GE(Sequence().solve(rolling_at(lateral, cant)).result.totals.Fy, least - 1) << lateral;
  }
}

TEST(PrescribedLateralForce, WhatCannotBeIsRefused) {
  EXPECT_THAT(message_of([] { Sequence().solve(rolling_at(0, "load.force_y = 1e9\n")); }),
              AllOf(HasSubstr("No lateral displacement gives a lateral force of 1e+09 N"),
                    HasSubstr("the force on the rail is between")));
  EXPECT_THAT(message_of([] { rolling_at(0, "load.force_y = 1e4\nmotion.kind = \"transient\"\n"); }),
              HasSubstr("another one at each step"));
  EXPECT_THAT(message_of([] {
                parse_scene_file("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.approach = 0.1\n"
                                 "load.force_y = 1e4\n");
              }),
              HasSubstr("load.force is not given"));
}

} // namespace
