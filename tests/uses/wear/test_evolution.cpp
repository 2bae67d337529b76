#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/uses/wear/evolution.hpp"
#include "tests/base/temporary_folder.hpp"
#include "tests/uses/wear/area_between.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace {

using namespace bem_contact;
using namespace bem_contact::wear;
using ::testing::HasSubstr;

std::vector<Point2> circle(double radius) {
  std::vector<Point2> out;
  for (int i = 0; i <= 200; ++i) {
    const double angle = -0.5 + 0.005 * i;
    out.push_back({radius * std::sin(angle), radius * (1 - std::cos(angle))});
  }
  return out;
}

DepthOverS band(double middle, double half, double depth) {
  DepthOverS out;
  out.width = 0.2;
  for (double s = middle - half; s <= middle + half; s += out.width) {
    out.s.push_back(s);
    out.depth.push_back(depth * (1 - std::pow((s - middle) / half, 2)));
  }
  return out;
}

/// Spreading keeps the area of the rows, and moving the points keeps it on a curved profile too.
TEST(WornProfile, KeepsTheVolume) {
  const std::vector<Point2> before = circle(13);
  const DepthOverS wear = band(1, 3, 0.1);
  Depths depths(before);
  depths.add(wear, 0.7, 2);
  EXPECT_NEAR(depths.area(), 0.7 * wear.area(), 1e-9 * wear.area());
  const std::vector<Point2> after = worn(before, depths.values(), depths.area());
  EXPECT_NEAR(area_between(before, after), depths.area(), 1e-9 * depths.area());
}

/// Nothing grows, and what lies far from the worn band stays where it is.
TEST(WornProfile, OnlyLosesMaterialWhereItIsWorn) {
  const std::vector<Point2> before = circle(13);
  Depths depths(before);
  depths.add(band(1, 1, 0.1), 1, 2);
  for (const double depth : depths.values())
    EXPECT_GE(depth, 0);
  const std::vector<Point2> after = worn(before, depths.values(), depths.area());
  EXPECT_EQ(before.front(), after.front());
  EXPECT_EQ(before.back(), after.back());
}

/// A smooth depth comes through the spreading with little change: 2 % for a band of six wavelengths.
TEST(WornProfile, KeepsTheShapeOfWideBands) {
  const std::vector<Point2> before = circle(100);
  Depths depths(before);
  depths.add(band(0, 12, 0.1), 1, 2);
  EXPECT_NEAR(depths.largest(), 0.1, 0.002);
}

/// A parabola over a half width a, spread by a kernel of variance v, is shallower by v / a^2: rows have
/// width^2 / 12, a cubic B-spline a third of the square of its knots' distance, a third of the wavelength.
TEST(WornProfile, SaysHowMuchOfTheDeepestPlaceSmoothingTakes) {
  const std::vector<Point2> before = points_of(ProfileCurve::through_points("circle", circle(13)));
  const double half = 1.4;
  for (const double wavelength : {0.7, 3.0}) {
    Depths depths(before);
    DepthOverS wear = band(1, half, 0.1);
    for (const double weight : {0.3, 0.7}) // two contacts in one place are one
      depths.add(wear, weight, wavelength);
    const double variance = std::pow(wavelength / 3, 2) / 3 + wear.width * wear.width / 12;
    const double taken = variance / (half * half);
    EXPECT_NEAR(depths.smoothed_off(), taken, 0.15 * taken) << wavelength; // of 3 mm the parabola ends
    EXPECT_NEAR(depths.largest(), 0.1 * (1 - depths.smoothed_off()), 1e-9) << wavelength;
  }
}

/// Rows of one depth stay even, however short the smoothing: what rows do not show is not made.
TEST(WornProfile, MakesNoWavesOfItsOwn) {
  DepthOverS wear;
  wear.width = 0.4;
  for (double s = -5; s <= 5; s += wear.width) {
    wear.s.push_back(s);
    wear.depth.push_back(0.1);
  }
  const std::vector<Point2> before = circle(13);
  Depths depths(before);
  depths.add(wear, 1, 0.8);
  const std::vector<double> s = ProfileCurve::through_points("circle", before).joints();
  for (std::size_t i = 0; i < s.size(); ++i)
    if (std::abs(s[i]) < 4) {
      EXPECT_NEAR(depths.values()[i], 0.1, 3e-3) << s[i];
    }
}

std::vector<CollectiveCase> collective() {
  std::vector<CollectiveCase> out;
  for (const double lateral : {0.0, 1.0})
    out.push_back(
        {parse_scene_file("kind = \"wheel_rail\"\nrail.profile = \"60E1\"\nwheel.profile = \"S1002\"\n"
                          "solver.model = \"halfspace\"\nload.force = 8e4\nposition.lateral = " +
                          std::to_string(lateral) +
                          "\n[motion]\nxi = 2e-3\nfree_rolling = false\n[grid]\ndx = 1\nds = 0.5\n"),
         1.0});
  return out;
}

std::filesystem::path folder() {
  static const TemporaryFolder all;
  const auto out = all / testing::UnitTest::GetInstance()->current_test_info()->name();
  std::filesystem::create_directories(out);
  return out;
}

/// Half steps halve the error: depths after the same revolutions, with steps of 1, 1/2 and 1/4 of the cap.
/// The smoothing is the same in all of them.
TEST(Evolution, IsOfFirstOrder) {
  const auto depth_with = [](int steps) {
    EvolutionOptions options{.law = EnergyLaw{.mild_until = 1e9, .severe_until = 1e9}, .cap = 1};
    WornPair pair = unworn(collective().front().scene);
    for (int i = 1; i <= steps; ++i)
      pair = wear_step(pair, collective(), options, 0.08 * i / steps, folder());
    return pair.rail.area / pair.revolutions; // the mean rate up to 0.08 mm
  };
  const double one = depth_with(2), two = depth_with(4), four = depth_with(8);
  RecordProperty("ratio", std::to_string((one - two) / (two - four)));
  EXPECT_NEAR((one - two) / (two - four), 2, 0.7) << one << " " << two << " " << four;
}

/// A step says what its smoothing took of the deepest place, on the flange more than elsewhere.
TEST(Evolution, SaysWhatSmoothingTook) {
  std::vector<CollectiveCase> cases = collective();
  cases.pop_back();
  cases[0].scene.position.lateral = 6.6;
  cases[0].scene.position.rail_inclination = 0.025;
  cases[0].scene.grid.dx = 0.3;
  cases[0].scene.grid.ds = 0.1;
  const WornPair before = unworn(cases.front().scene);
  const WornPair fine = wear_step(before, cases, {.smoothing = 0.3}, 1, folder());
  const WornPair coarse = wear_step(before, cases, {.smoothing = 3}, 1, folder());
  EXPECT_LT(fine.smoothed_off, 0.5 * coarse.smoothed_off);
  EXPECT_GT(coarse.smoothed_off, 0.05);
  const WearRow row = history_row(1, coarse, 460);
  EXPECT_EQ(row.smoothing, 3);
  EXPECT_EQ(row.smoothed_off, coarse.smoothed_off);
  // as much goes in as many revolutions, but spread wider: it takes longer until the deepest is as deep
  EXPECT_NEAR(coarse.revolutions / fine.revolutions, (1 - fine.smoothed_off) / (1 - coarse.smoothed_off),
              0.02);
}

/// The volume that has gone is what lies between the profiles.
TEST(Evolution, AccountsForItsVolume) {
  const WornPair before = unworn(collective().front().scene);
  const WornPair after = wear_step(before, collective(), {.cap = 0.05}, 1, folder());
  EXPECT_GT(after.rail.area, 0);
  EXPECT_NEAR(area_between(before.rail.points, after.rail.points), after.rail.area, 1e-9 * after.rail.area);
  EXPECT_NEAR(after.wheel.area, after.rail.area, 1e-9 * after.rail.area);
  EXPECT_NEAR(std::max(after.rail.largest(), after.wheel.largest()), 0.05, 1e-9);
}

/// What steel bears acts in every step: the contact is wider, and so is what it wears.
TEST(Evolution, TakesTheLimitOfPressureOfTheScene) {
  const auto worn_places = [](std::optional<double> limit) {
    std::vector<CollectiveCase> cases = collective();
    for (CollectiveCase& one : cases)
      one.scene.rail.limit_pressure = limit;
    const WornPair after = wear_step(unworn(cases.front().scene), cases, {.cap = 0.02}, 1, folder());
    EXPECT_NEAR(after.largest(), 0.02, 1e-9);
    return after.rail.area;
  };
  const double elastic = worn_places({}), beyond = worn_places(1e5), limited = worn_places(600);
  EXPECT_NEAR(beyond / elastic, 1, 1e-6);
  EXPECT_GT(limited, 1.05 * elastic); // as deep, but wider
}

/// The map of KTH as a table of the scene is the map that a scene without one has. Its last number is used.
TEST(Evolution, TakesTheWearMapOfTheScene) {
  const auto map_of = [](const std::string& wear) {
    return wear_map_of(
        parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 8e4\n" + wear));
  };
  EXPECT_EQ(map_of(""), std::nullopt);
  const auto kth = map_of("[wear]\nspeeds = [200, 700]\npressures = [2400]\n"
                          "coefficients = [5.5e-4, 35e-4, 5.5e-4, 350e-4, 350e-4, 350e-4]\n");
  ASSERT_TRUE(kth);
  EXPECT_EQ(law_named("archard", 3000, 2e4, kth), law_named("archard", 3000, 2e4));
  const auto one = map_of("wear.coefficients = [4e-4]\n");
  EXPECT_EQ(coefficient(*one, 500, 5000), 4e-4);
  EXPECT_THROW(validate(law_named("archard", 3000, 2e4, map_of("wear.speeds = [200]\n"))), InputError);
}

TEST(Evolution, WearsOneBodyAlone) {
  const WornPair before = unworn(collective().front().scene);
  const WornPair after = wear_step(before, collective(), {.rail = false, .cap = 0.05}, 0.02, folder());
  EXPECT_EQ(after.rail.points, before.rail.points);
  EXPECT_NEAR(after.wheel.largest(), 0.02, 1e-9);
}

std::string refusal_of(const std::vector<CollectiveCase>& cases, const EvolutionOptions& options = {},
                       double depth = 0.1) {
  try {
    validate(cases, options, depth);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Evolution, RefusesWhatCannotWear) {
  EXPECT_EQ(refusal_of(collective()), "");
  EXPECT_THAT(refusal_of({}), HasSubstr("The load collective is empty"));
  for (const double depth : {0.0, -0.1, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THAT(refusal_of(collective(), {}, depth), HasSubstr("depths are positive and finite"));
  auto cases = collective();
  cases[1].weight = -1;
  EXPECT_THAT(refusal_of(cases), HasSubstr("weights must be positive"));
  cases = collective();
  cases[0].scene.wear.coefficients = {1e-4};
  EXPECT_THAT(refusal_of(cases), HasSubstr("different wear maps"));
  cases = collective();
  cases[1].scene.rail.profile = "54E1";
  EXPECT_THAT(refusal_of(cases), HasSubstr("different bodies"));
  cases = collective();
  cases[1].scene.position.uneven.joint.dip = 1;
  EXPECT_THAT(refusal_of(cases), HasSubstr("An uneven wheel or rail cannot wear"));
  EXPECT_THAT(refusal_of(collective(), {.cap = 0}), HasSubstr("depth of a step"));
  EXPECT_THAT(refusal_of(collective(), {.kept_turn = std::nan("")}), HasSubstr("kept turn"));
  EXPECT_THAT(refusal_of(collective(), {.smoothing = std::nan("")}), HasSubstr("smoothing"));
}

/// Nobody is advised to smooth profiles that wear has written; these scatter by 2 micrometres.
TEST(Evolution, SaysNothingOfItsOwnProfiles) {
  const TemporaryFolder own;
  for (const char* name : {"rail", "wheel"})
    std::filesystem::copy_file(std::string(CONFORMAL_SOURCE_DIR "/data/bodies/worn_") + name + ".txt",
                               own.path() / (std::string(name) + ".txt"));
  SceneFile scene;
  scene.kind = SceneKind::wheel_rail;
  testing::internal::CaptureStderr();
  read_profiles_of_step(scene, {}, own.path());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

} // namespace
