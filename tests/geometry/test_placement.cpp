#include "bem_contact/geometry/contact_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_locus.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/base/message.hpp"
#include "tests/geometry/shapes.hpp"
#include "tests/geometry/with_own_locus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

using std::numbers::pi;

WheelOnRail s1002_on_60e1(WheelsetPosition position) {
  return place(position, named_profile("60E1", ProfileKind::rail),
               named_profile("S1002", ProfileKind::wheel));
}

WheelsetPosition at_lateral(double lateral) {
  WheelsetPosition position;
  position.lateral = lateral;
  return position;
}

TEST(Placement, TheGaugeFaceIsAtHalfTheGauge) {
  for (const double cant : {0.0, 0.025, 0.05}) {
    WheelsetPosition position;
    position.rail_inclination = cant;
    const WheelOnRail pair = s1002_on_60e1(position);
    double top = 1e9, face = 1e9;
    const auto scan = [&](auto visit) {
      for (double s = pair.rail.s_begin(); s <= pair.rail.s_end(); s += 0.002)
        visit(pair.rail_at(s).position);
    };
    scan([&](Point2 p) { top = std::min(top, p.z); });
    scan([&](Point2 p) { face = p.z <= top + 14 ? std::min(face, p.y) : face; });
    EXPECT_NEAR(top, 0, 1e-4) << cant;
    EXPECT_NEAR(face, 717.5, 2e-3) << cant;
  }
}

TEST(Placement, TheRailWithoutCantStandsHalfItsHeadBeyondTheGaugeFace) {
  // EN 13674-1: R13 about (23.0160, -14.9491); at 14 mm below the top its half width is
  const double half_width = 23.0160 + std::sqrt(13.0 * 13.0 - 0.9491 * 0.9491);
  EXPECT_NEAR(s1002_on_60e1({}).rail_pose.origin.y, 717.5 + half_width, 1e-3);
}

TEST(Placement, CantLeansTheRailTowardsTheTrackCentre) {
  WheelsetPosition position;
  position.rail_inclination = 0.025;
  const WheelOnRail pair = s1002_on_60e1(position);
  const Point2 up = pair.rail_pose.to_track({0, -1}) - pair.rail_pose.to_track({0, 0});
  EXPECT_NEAR(up.y, -std::sin(0.025), 1e-12);
  EXPECT_NEAR(up.z, -std::cos(0.025), 1e-12);
  EXPECT_NEAR(pair.rail_at(0).delta, -0.025, 1e-9);
}

TEST(Placement, TheFlangeBackIsAtHalfTheBackToBackDistance) {
  const WheelOnRail pair = s1002_on_60e1(at_lateral(3));
  EXPECT_DOUBLE_EQ(pair.wheel_pose.to_track({-70, 0}).y, 683);
}

TEST(Placement, RollAboutTheWheelsetsCentreLowersTheRightWheel) {
  WheelsetPosition position;
  position.roll = 0.01;
  const WheelOnRail pair = s1002_on_60e1(position);
  const Point2 tape = pair.wheel_pose.to_track({0, 0});
  EXPECT_NEAR(tape.y, 750 * std::cos(0.01) - 460 * std::sin(0.01), 1e-9);
  EXPECT_NEAR(tape.z, -460 + 750 * std::sin(0.01) + 460 * std::cos(0.01), 1e-9);
}

TEST(Placement, TheLeftWheelIsTheMirrorImage) {
  WheelsetPosition right, left;
  right.lateral = 3, right.yaw = 0.01, right.roll = 0.02, right.rail_inclination = 0.025;
  right.rail_lateral = 0.4, right.rail_vertical = 0.3, right.rail_roll = 0.01;
  left = right;
  left.side = WheelSide::left;
  left.lateral = -3, left.yaw = -0.01, left.roll = -0.02, left.rail_lateral = -0.4, left.rail_roll = -0.01;
  const WheelOnRail a = s1002_on_60e1(right), b = s1002_on_60e1(left);
  EXPECT_EQ(a.rail_pose.origin.y, b.rail_pose.origin.y);
  EXPECT_EQ(a.rail_pose.origin.z, b.rail_pose.origin.z);
  EXPECT_EQ(a.rail_pose.angle, b.rail_pose.angle);
  EXPECT_EQ(a.wheel_frame().centre, b.wheel_frame().centre);
  EXPECT_EQ(a.wheel_frame().axle, b.wheel_frame().axle);
  // And a wheelset rolled right side down lifts the left wheel.
  right = left = {};
  right.roll = left.roll = 0.01;
  left.side = WheelSide::left;
  EXPECT_GT(s1002_on_60e1(right).wheel_frame().centre[2], -460);
  EXPECT_LT(s1002_on_60e1(left).wheel_frame().centre[2], -460);
}

TEST(Placement, YawTurnsTheFrontToTheRightAndTakesTheRightWheelBack) {
  WheelsetPosition position;
  position.yaw = 0.02;
  position.lateral = 5;
  const WheelFrame frame = s1002_on_60e1(position).wheel_frame();
  EXPECT_NEAR(frame.forward[0], std::cos(0.02), 1e-15);
  EXPECT_NEAR(frame.forward[1], std::sin(0.02), 1e-15);
  EXPECT_NEAR(frame.centre[0], -750 * std::sin(0.02), 1e-12);
  EXPECT_NEAR(frame.centre[1], 5 + 750 * std::cos(0.02), 1e-12);
}

/// A keeper or a check rail beside the head, as high as the head or higher, is not where the gauge is taken.
TEST(Placement, TheGaugeIsTakenOnTheRunningHead) {
  const ProfileCurve head = named_profile("60E1", ProfileKind::rail);
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(head, 0.4))
    points.push_back(p.position);
  for (const double height : {0.0, 0.5, 20.0, 60.0}) {
    std::vector<Point2> both{{-110, 45}, {-110, -height}, {-80, -height}, {-80, 45}};
    both.insert(both.end(), points.begin(), points.end());
    const WheelOnRail pair = place({}, ProfileCurve::through_points("keeper", both),
                                   named_profile("S1002", ProfileKind::wheel)),
                      alone = s1002_on_60e1({});
    EXPECT_NEAR(pair.rail_pose.origin.y, alone.rail_pose.origin.y, 0.01) << height;
    EXPECT_NEAR(pair.rail_pose.origin.z, alone.rail_pose.origin.z, 0.01) << height;
  }
}

TEST(Placement, DeviationsMoveTheRailAlone) {
  WheelsetPosition position;
  const WheelOnRail nominal = s1002_on_60e1(position);
  position.rail_lateral = 1.5, position.rail_vertical = 0.7, position.rail_roll = 0.02;
  const WheelOnRail moved = s1002_on_60e1(position);
  const Point2 by = moved.rail_at(0).position - nominal.rail_at(0).position;
  EXPECT_NEAR(by.y, 1.5, 1e-12);
  EXPECT_NEAR(by.z, 0.7, 1e-12);
  EXPECT_NEAR(moved.rail_at(10).delta - nominal.rail_at(10).delta, 0.02, 1e-14);
  EXPECT_EQ(moved.wheel_frame().centre, nominal.wheel_frame().centre);
}

TEST(Placement, PoseGoesThereAndBack) {
  const Pose pose{{12, -3}, 0.7};
  const Point2 p = pose.to_section(pose.to_track({4, 9}));
  EXPECT_NEAR(p.y, 4, 1e-12);
  EXPECT_NEAR(p.z, 9, 1e-12);
}

TEST(Placement, RefusesARailWithoutGaugeFace) {
  try {
    place({}, shapes::rail_arc(300, 0.1), named_profile("S1002", ProfileKind::wheel));
    FAIL() << "a shallow arc has no gauge face";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has no gauge face"));
    EXPECT_THAT(error.what(), HasSubstr("gauge_height"));
    EXPECT_THAT(error.what(), HasSubstr("rail.place = \"absolute\""));
  }
}

TEST(Placement, AbsolutePutsTheOriginsOfTheSections) {
  WheelsetPosition position;
  position.rail_origin = Point2{3, 2};
  position.wheel_origin = Point2{5, -1};
  position.rail_inclination = 0.025;
  position.lateral = 0.5;
  position.rail_vertical = 0.25;
  // Neither has a gauge face or a flange.
  const WheelOnRail pair = place(position, shapes::rail_arc(300, 0.1), shapes::wheel_arc(20, 0.5));
  EXPECT_NEAR(norm(pair.rail_pose.origin - Point2{3, 2.25}), 0, 1e-12);
  EXPECT_DOUBLE_EQ(pair.rail_pose.angle, -0.025);
  EXPECT_NEAR(norm(pair.wheel_pose.to_track({0, 0}) - Point2{5.5, -1}), 0, 1e-9);
}

TEST(Placement, AbsoluteIsTheSameAsByGaugeAtTheSamePlace) {
  const WheelOnRail by_gauge = s1002_on_60e1(at_lateral(3));
  WheelsetPosition position = at_lateral(3);
  position.rail_origin = by_gauge.rail_pose.origin;
  position.wheel_origin = Point2{position.back_to_back / 2 + 70, 0};
  const WheelOnRail absolute = s1002_on_60e1(position);
  EXPECT_EQ(absolute.rail_pose.origin.y, by_gauge.rail_pose.origin.y);
  EXPECT_EQ(absolute.rail_pose.origin.z, by_gauge.rail_pose.origin.z);
  EXPECT_EQ(absolute.wheel_frame().centre, by_gauge.wheel_frame().centre);
}

TEST(ContactSearch, CirclesTouchOnTheLineOfTheirCentres) {
  // Lower centre (0, 80), upper centre (3, -20 - lift): they touch where the distance of the centres is 100.
  WheelOnRail pair = shapes::arcs(80, 20, 460);
  pair.wheel_pose.origin = {3, -5};
  const std::vector<TouchPoint> touch = lower_to_touch(pair);
  ASSERT_EQ(touch.size(), 1u);
  const double angle = std::asin(3.0 / 100.0);
  EXPECT_NEAR(touch[0].distance, 0, 1e-9);
  EXPECT_NEAR(touch[0].delta, angle, 1e-5);
  EXPECT_NEAR(touch[0].position.y, 80 * std::sin(angle), 1e-4);
  EXPECT_NEAR(pair.wheel_pose.origin.z, 100 - 100 * std::cos(angle), 1e-8);
}

TEST(ContactSearch, TwoPointContactOfS1002On60E1IsNearSixPointSevenMillimetres) {
  // y*: where the deepest point jumps from the gauge corner to the flange. Li and Kalker 1998
  // found two-point contact around such a position.
  const auto deepest = [](double lateral) {
    WheelOnRail pair = s1002_on_60e1(at_lateral(lateral));
    return lower_to_touch(pair);
  };
  double lo = 5, hi = 8;
  ASSERT_GT(deepest(lo).front().delta, -0.4);
  ASSERT_LT(deepest(hi).front().delta, -1.0);
  for (int i = 0; i < 20; ++i) {
    const double mid = 0.5 * (lo + hi);
    (deepest(mid).front().delta > -0.9 ? lo : hi) = mid;
  }
  // Rail and flange root both have R13 there: the point runs 7 mm within 2 um of lateral displacement.
  EXPECT_GT(deepest(lo - 1e-3).front().rail_s - deepest(lo + 1e-3).front().rail_s, 6.0);
  RecordProperty("y_star_mm", std::to_string(lo));
  std::printf("y* = %.4f mm\n", lo);
  EXPECT_NEAR(lo, 6.7, 0.15);
}

TEST(ContactSearch, TheWheelNeverCutsIntoTheRailOnceLowered) {
  for (const double lateral : {-5.0, 0.0, 4.0, 6.5, 7.5}) {
    WheelOnRail pair = s1002_on_60e1(at_lateral(lateral));
    const std::vector<TouchPoint> touch = lower_to_touch(pair);
    EXPECT_DOUBLE_EQ(touch.front().distance, 0);
    for (const TouchPoint& p : find_touch_points(pair))
      EXPECT_GE(p.distance, -1e-9) << lateral;
    // At a touch point the tangents are parallel.
    EXPECT_NEAR(ContactLocus(pair).at(touch.front().wheel_s)->delta - pi, touch.front().delta, 2e-3)
        << lateral;
  }
}

TEST(ContactSearch, RefusesAWheelBesideTheRail) {
  WheelOnRail pair = s1002_on_60e1(at_lateral(400));
  try {
    lower_to_touch(pair);
    FAIL() << "the wheel hangs beside the rail";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("never meets the rail"));
    EXPECT_THAT(error.what(), HasSubstr("position.lateral"));
  }
}

TEST(ContactSearch, RefusesAContactAtTheEndOfAProfile) {
  // The circles' tangent point would be at the angle asin(15/100), beyond the rail's 0.1.
  WheelOnRail pair{shapes::rail_arc(80, 0.1), shapes::wheel_arc(20, 0.5), {}, {{15, -5}, 0}, 460};
  EXPECT_THAT(message_of([&] { lower_to_touch(pair); }), HasSubstr("at the end of a profile"));
}

} // namespace
