#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/settings.hpp"

#include "bem_contact/base/error.hpp"
#include "tests/geometry/brute_force.hpp"
#include "tests/geometry/shapes.hpp"
#include "tests/geometry/with_own_locus.hpp"
#include "tests/profile/curves.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <random>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

struct Tally {
  int cases = 0, refused = 0, several = 0;
  double worst = 0;
};

void compare_with_brute_force(const TabulatedProfile& rail, const TabulatedProfile& wheel, int cases,
                              unsigned seed, Tally& tally, double reach = 0.1) {
  BruteForce brute(rail, wheel, reach);
  std::mt19937 random(seed);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
  for (int i = 0; i < tests::alike(cases); ++i) {
    WheelsetPosition position;
    position.side = i % 2 ? WheelSide::left : WheelSide::right;
    position.lateral = uniform(-10, 10);
    position.yaw = uniform(-0.024, 0.024);
    position.roll = uniform(-0.01, 0.01);
    position.rail_inclination = 0.025 * (i % 3);
    position.rail_lateral = uniform(-2, 2);
    position.rail_vertical = uniform(-2, 2);
    position.rail_roll = uniform(-0.01, 0.01);
    ++tally.cases;
    WheelOnRail pair = place(position, rail, wheel);
    std::vector<TouchPoint> found;
    try {
      found = find_touch_points(pair);
    } catch (const InputError&) {
      ++tally.refused;
      continue;
    }
    const auto minima = brute.search(position, pair, 0.5);
    ASSERT_FALSE(minima.empty());
    tally.worst = std::max(tally.worst, std::abs(found.front().distance - minima.front().distance));
    tally.several += found.size() > 1 && found[1].distance < found[0].distance + 0.5;
    EXPECT_NEAR(found.front().distance, minima.front().distance,
                BruteForce::tolerance(pair, found.front().rail_s))
        << "case " << i << ": y " << position.lateral << " yaw " << position.yaw << " brute at x "
        << minima.front().x << " y " << minima.front().y << ", found x " << found.front().x << " y "
        << found.front().position.y;
    // Every minimum is there, unless less than a barrier tells it from a lower one.
    for (const BruteForce::Minimum& m : minima) {
      const bool known = std::ranges::any_of(found, [&](const TouchPoint& p) {
        return std::abs(p.distance - m.distance) < BruteForce::tolerance(pair, p.rail_s);
      });
      if (!known) {
        EXPECT_LT(brute.barrier(m), flat_distance)
            << "case " << i << ": " << m.distance << " at x " << m.x << " y " << m.y;
      }
    }
    const WheelFrame frame = pair.wheel_frame();
    for (const TouchPoint& p : found) {
      const Point2 section = wheel.at(p.wheel_s).position;
      const double forward = p.x - frame.centre[0] - section.y * frame.axle[0];
      EXPECT_TRUE(brute.is_minimum(p, std::asin(forward / (position.wheel_radius + section.z)),
                                   BruteForce::tolerance(pair, p.rail_s)))
          << "case " << i << ": " << p.distance << " at x " << p.x << " y " << p.position.y;
    }
  }
}

void report(const char* what, const Tally& tally) {
  std::printf("%s: %d positions, %d refused, %d with several minima within .5 mm, worst difference %.1e mm\n",
              what, tally.cases, tally.refused, tally.several, tally.worst);
}

TEST(ContactSearch, FindsWhatBruteForceFindsInTwoDimensions) {
  Tally tally;
  compare_with_brute_force(named_profile("60E1", ProfileKind::rail),
                           named_profile("S1002", ProfileKind::wheel), 1000, 1, tally);
  report("S1002 on 60E1", tally);
  EXPECT_LT(tally.refused, 0.01 * tally.cases);
  EXPECT_GT(tally.several, 0.02 * tally.cases);
}

TEST(ContactSearch, FindsWhatBruteForceFindsOnWornProfiles) {
  const std::filesystem::path folder = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies";
  Tally tally;
  compare_with_brute_force(read_profile(folder / "worn_rail.txt", ProfileKind::rail),
                           read_profile(folder / "worn_wheel.txt", ProfileKind::wheel), 200, 2, tally);
  report("worn on worn", tally);
  EXPECT_LT(tally.refused, 0.1 * tally.cases);
}

/// A folder of profile files, any number of each kind: the Manchester benchmark's, or one's own.
TEST(ContactSearch, FindsWhatBruteForceFindsOnSampleProfiles) {
  const char* folder = std::getenv("CONFORMAL_SAMPLE_PROFILES");
  if (!folder)
    GTEST_SKIP() << "set CONFORMAL_SAMPLE_PROFILES to a folder of .prr, .ban, .prw and .whl files";
  std::vector<TabulatedProfile> rails, wheels;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string kind = entry.path().extension().string();
    if (kind == ".prr" || kind == ".ban")
      rails.push_back(read_profile(entry.path(), ProfileKind::rail));
    else if (kind == ".prw" || kind == ".whl")
      wheels.push_back(read_profile(entry.path(), ProfileKind::wheel));
  }
  Tally tally;
  for (const TabulatedProfile& rail : rails)
    for (const TabulatedProfile& wheel : wheels)
      compare_with_brute_force(rail, wheel, 100, 3, tally);
  report("sample profiles", tally);
}

TabulatedProfile polyline(const char* name, std::vector<Point2> corners) {
  std::vector<Point2> points{corners.front()};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k)
    for (int i = 1; i <= 10; ++i)
      points.push_back(corners[k] + 0.1 * i * (corners[k + 1] - corners[k]));
  return ProfileCurve::through_points(name, points);
}

TEST(ContactSearch, FindsWhatBruteForceFindsAtKinks) {
  // A tread with a square flange: a hollow corner and two sharp edges, on which a yawed wheel rides.
  Tally tally;
  compare_with_brute_force(named_profile("60E1", ProfileKind::rail),
                           polyline("square flange", {{60, -2}, {-32, 0}, {-34, 20}, {-55, 21}, {-70, 5}}),
                           60, 4, tally, 0.6);
  report("square flange on 60E1", tally);
  EXPECT_EQ(tally.refused, 0);
}

/// Corners rounded by arcs of 20 points; a corner of radius 0 stays.
std::vector<Point2> rounded(const std::vector<std::pair<Point2, double>>& corners) {
  std::vector<Point2> out{corners.front().first};
  const auto walk_to = [&](Point2 p) {
    const Point2 from = out.back();
    const int steps = 1 + static_cast<int>(norm(p - from));
    for (int i = 1; i <= steps; ++i)
      out.push_back(from + (i / static_cast<double>(steps)) * (p - from));
  };
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    const auto [p, radius] = corners[k];
    const Point2 a = p - corners[k - 1].first, b = corners[k + 1].first - p;
    const Point2 in = (1 / norm(a)) * a, on = (1 / norm(b)) * b;
    const double turn = angle_from_to(in, on), cut = radius * std::tan(std::abs(turn) / 2);
    walk_to(p - cut * in);
    const Point2 begin = out.back();
    const double side = turn > 0 ? 1 : -1;
    const Point2 centre = begin + (side * radius) * Point2{-in.z, in.y};
    for (int i = 1; i <= 20 && radius > 0; ++i)
      out.push_back(centre + turned(begin - centre, turn * i / 20));
  }
  walk_to(corners.back().first);
  return out;
}

/// The flange of a tram's wheel in the groove of its rail, whose walls are vertical or lean over it: it
/// stands on the head, on the bottom of the groove, or with its back on the keeper.
TEST(ContactSearch, FindsWhatBruteForceFindsBehindVerticalWalls) {
  const TabulatedProfile wheel(ProfileCurve::through_points(
      "tram", rounded({{{45, -1.1}, 0}, {{-36, 0.5}, 9}, {{-43, 22}, 4}, {{-56, 24}, 6}, {{-58, 3}, 0}})));
  Tally tally;
  for (const double over : {0.0, 0.6}) // by how much the walls lean over the groove, mm
    for (const double bottom : {19.0, 47.0}) {
      const TabulatedProfile rail(ProfileCurve::through_points("groove", rounded({{{-100, 9}, 0},
                                                                                  {{-60, 8}, 3},
                                                                                  {{-60 - over, bottom}, 3},
                                                                                  {{-28 + over, bottom}, 3},
                                                                                  {{-28, 1}, 9},
                                                                                  {{0, 0}, 100},
                                                                                  {{28, 1}, 9},
                                                                                  {{28, 25}, 0}})));
      compare_with_brute_force(rail, wheel, 25, 6, tally, 0.35);
    }
  report("tram wheel in a groove", tally);
  EXPECT_EQ(tally.refused, 0);
}

TEST(ContactSearch, AFlangeBackStandsOnTheKeeper) {
  const TabulatedProfile wheel(ProfileCurve::through_points(
      "tram", rounded({{{45, -1.1}, 0}, {{-20, 0.5}, 9}, {{-30, 22}, 5}, {{-42, 24}, 7}, {{-42, 3}, 0}})));
  const TabulatedProfile rail(ProfileCurve::through_points("groove", rounded({{{-100, 8}, 0},
                                                                              {{-66, 8}, 3},
                                                                              {{-66, 47}, 3},
                                                                              {{-28, 47}, 3},
                                                                              {{-28, 1}, 9},
                                                                              {{0, 0}, 100},
                                                                              {{28, 1}, 9},
                                                                              {{28, 25}, 0}})));
  WheelsetPosition position;
  position.gauge_height = 10;
  position.rail_origin = Point2{750, 0};
  position.wheel_origin = Point2{750, 0};
  position.lateral = -36; // the back at -78, 12 mm beyond the keeper's wall
  WheelOnRail pair = place(position, rail, wheel);
  const TouchPoint touch = lower_to_touch(pair).front();
  EXPECT_LT(touch.position.y, 750 - 66);
  EXPECT_NEAR(touch.position.z, 8, 0.2);
  EXPECT_GT(pair.wheel.at(touch.wheel_s).position.z, 20); // on the flange
  position.lateral = -10;                                 // free of the keeper
  pair = place(position, rail, wheel);
  EXPECT_GT(lower_to_touch(pair).front().position.y, 750 - 30);
}

TEST(ContactSearch, AYawedFlangeTouchesInFront) {
  // Front to the right: the flange of the right wheel, which runs to the left of its rail, meets it in front
  // of the wheel's centre by r tan(yaw) tan(slope); the wheel itself has gone back by 750 mm sin(yaw).
  for (const double yaw : {0.01, -0.01}) {
    WheelsetPosition position;
    position.lateral = 9;
    position.yaw = yaw;
    WheelOnRail pair =
        place(position, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel));
    const TouchPoint touch = lower_to_touch(pair).front();
    ASSERT_LT(touch.delta, -1.0);
    const double radius = 460 + pair.wheel.at(touch.wheel_s).position.z;
    EXPECT_NEAR(touch.x, -750 * std::sin(yaw) + radius * std::tan(yaw) * std::tan(-touch.delta), 0.05 * 17);
    EXPECT_GT(yaw * (touch.x + 750 * std::sin(yaw)), 0);
  }
}

TEST(ContactSearch, AYawedBallTouchesBelowItsCentre) {
  // A ball of radius 20 about the axle, 700 mm from the vertical it is yawed about.
  WheelOnRail pair = shapes::arcs(80, 20, 20);
  pair.yaw = 0.3;
  pair.centre_y = -700;
  const TouchPoint touch = lower_to_touch(pair).front();
  const double y = -700 + 700 * std::cos(0.3);
  EXPECT_NEAR(touch.x, -700 * std::sin(0.3), 1e-5);
  EXPECT_NEAR(touch.delta, std::asin(y / 100), 1e-4);
}

TEST(ContactSearch, ALineContactIsOne) {
  // A conical wheel on a rail whose head has a flat of the same slope, 10 mm wide between arcs of 40 mm:
  // within flat_distance the arcs add sqrt(2 * 40 * 2e-5) on either side.
  const double slope = -0.05;
  std::vector<CurvePiece> head{arc_piece({0, 0}, slope - 1, 1 / 40.0, 40), arc_piece({0, 0}, slope, 0, 10),
                               arc_piece({0, 0}, slope, 1 / 40.0, 40)};
  const TabulatedProfile rail(ProfileCurve::from_pieces("flat head", head));
  const TabulatedProfile wheel(ProfileCurve::from_pieces(
      "cone", {line_piece({300, 300 * std::tan(slope)}, {-300, -300 * std::tan(slope)})}));
  WheelOnRail pair{rail, wheel, {}, {{rail.at(0).position.y, 0}, 0}, 460};
  const std::vector<TouchPoint> touch = lower_to_touch(pair);
  ASSERT_EQ(touch.size(), 1u);
  EXPECT_NEAR(touch[0].s_to - touch[0].s_from, 10 + 2 * std::sqrt(80 * flat_distance), 1e-3);
  // Yawed, the cone is round along x there and touches in a point or two, still reported once.
  pair.yaw = 0.02;
  EXPECT_EQ(lower_to_touch(pair).size(), 1u);
}

} // namespace
