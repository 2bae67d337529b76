#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/geometry/rail_height.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "tests/geometry/shapes.hpp"
#include "tests/geometry/with_own_locus.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace bem_contact;
using std::numbers::pi;

constexpr double radius = 460; // of the wheel, mm

WheelOnRail crowned_wheel(const Unevenness& what) {
  WheelOnRail pair = shapes::arcs(300, 600, radius, 0.1);
  pair.uneven = UnevenSurfaces(what, radius);
  return pair;
}

/// By how much the wheel is lowered from where it would touch if both bodies were even, mm.
double lowered(const Unevenness& what) {
  WheelOnRail pair = crowned_wheel(what);
  lower_to_touch(pair);
  return pair.wheel_pose.origin.z;
}

Unevenness new_flat(double length, double turned = 0) {
  Unevenness what;
  what.flat.length = length;
  what.flat.angle = turned;
  return what;
}

/// The same by looking at all x: between a wheel of this shape and this rail, unyawed, only x matters.
double lowered_by_brute_force(const Unevenness& what) {
  const UnevenSurfaces surfaces(what, radius);
  double least = std::numeric_limits<double>::infinity();
  for (int i = -30000; i <= 30000; ++i) {
    const double theta = i * 5e-6, r = radius - surfaces.depth(theta);
    least = std::min(least, radius - r * std::cos(theta) + surfaces.rail(r * std::sin(theta)));
  }
  return least;
}

TEST(WheelFlat, IsTheChordOfTheCircle) {
  const UnevenSurfaces surfaces(new_flat(60), radius);
  const double half = std::asin(30 / radius), below = std::sqrt(radius * radius - 900);
  for (const double part : {-0.99, -0.5, 0.0, 0.3, 0.8})
    EXPECT_NEAR((radius - surfaces.depth(part * half)) * std::cos(part * half), below, 1e-12);
  EXPECT_EQ(surfaces.depth(1.001 * half), 0);
  EXPECT_EQ(surfaces.depth(pi), 0);
  Unevenness by_depth;
  by_depth.flat.depth = radius - below;
  EXPECT_NEAR(UnevenSurfaces(by_depth, radius).depth(0.01), surfaces.depth(0.01), 1e-12);
}

/// A depth of its own scales the chord; rounded edges leave the middle and the circle beyond as they are, and
/// neither value nor slope jumps.
TEST(WheelFlat, HasRoundedEdges) {
  Unevenness what = new_flat(60);
  what.flat.depth = 0.9;
  what.flat.rounding = 20;
  const UnevenSurfaces rounded(what, radius);
  EXPECT_NEAR(rounded.depth(0), 0.9, 1e-12);
  EXPECT_EQ(rounded.depth(41 / radius), 0);
  double before = 0, slope = 0;
  for (double u = -45; u < 45; u += 0.01) {
    const double here = rounded.depth(u / radius);
    if (u > -44.9) {
      EXPECT_NEAR((here - before) / 0.01, slope, 1e-4) << u;
    }
    slope = u > -44.95 ? (here - before) / 0.01 : 0;
    before = here;
  }
}

/// As it turns, a new flat stands on an edge: the axle is at R cos(distance of the edge from below). A sharp
/// edge is found to 1e-8 rad, where the wheel's height changes by its slope.
TEST(WheelFlat, LowersTheWheelAsTheCircleOnItsChord) {
  const double half = std::asin(30 / radius);
  for (const double part : {0.0, 0.2, -0.2, 0.7, 1.0, 1.2}) {
    const double to_edge = std::max(0.0, half - std::abs(part) * half);
    EXPECT_NEAR(lowered(new_flat(60, part * half)), radius * (1 - std::cos(to_edge)), 1e-7) << part;
  }
}

TEST(WheelFlat, LiesOnTheRail) {
  WheelOnRail pair = crowned_wheel(new_flat(60));
  const TouchPoint touch = lower_to_touch(pair).front();
  EXPECT_NEAR(touch.x, 0, 1e-9);
  const CurvePoint top = pair.rail_at(touch.rail_s);
  const std::vector<ContactRow> rows{{top.s, top.position, top.delta}};
  const std::vector<double> x{-31, -29.9, -10, 0, 17, 29.9, 31};
  const std::vector<double> gap = undeformed_distance(pair, rows, x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double below = std::sqrt(radius * radius - 900), circle = std::sqrt(radius * radius - x[i] * x[i]);
    EXPECT_NEAR(gap[i], std::max(0.0, below - circle), 1e-9) << x[i];
  }
}

/// A wheel that has rolled carries its flat backwards; a whole turn brings it back.
TEST(WheelFlat, RollsWithTheWheel) {
  Unevenness turned = new_flat(60, 0.02), rolled = new_flat(60, 0.05);
  rolled.along = 0.03 * radius;
  EXPECT_NEAR(lowered(turned), lowered(rolled), 1e-12);
  turned.along = 2 * pi * radius;
  EXPECT_NEAR(lowered(turned), lowered(new_flat(60, 0.02)), 1e-9);
}

TEST(WheelPolygon, OfOneWaveIsAnEccentricWheel) {
  for (const double angle : {0.0, 0.7, pi}) {
    Unevenness what;
    what.polygon = {{1}, {0.5}, {angle}};
    // (R + e cos(theta - a)): to first order in e a circle whose centre is displaced by e towards a.
    EXPECT_NEAR(lowered(what), -0.5 * std::cos(angle), 0.5 * 0.5 / radius) << angle;
  }
}

TEST(WheelPolygon, TouchesWhereBruteForceTouches) {
  for (const double phase : {0.0, 0.05, 0.1, 0.157}) {
    Unevenness what;
    what.polygon = {{20, 7}, {0.05, -0.1}, {phase, 0.3}};
    EXPECT_NEAR(lowered(what), lowered_by_brute_force(what), 1e-7) << phase;
  }
}

/// Over a gap with sharp edges the wheel stands on both; before a step up it rises on the edge.
TEST(RailJoint, LowersTheWheelAsItsEdgesLetIt) {
  Unevenness what;
  what.joint = {.gap = 12, .rounding = 0};
  EXPECT_NEAR(lowered(what), radius - std::sqrt(radius * radius - 36), 1e-7);
  what.joint = {.at = 8, .step = -0.2, .rounding = 0};
  EXPECT_NEAR(lowered(what), std::min(0.0, radius - 0.2 - std::sqrt(radius * radius - 64)), 1e-7);
  what.along = 20;
  EXPECT_NEAR(lowered(what), -0.2, 1e-9);
  what.joint.step = 0.2; // the wheel has passed the edge by 12 mm, and hangs on it still
  EXPECT_NEAR(lowered(what), std::min(0.2, radius - std::sqrt(radius * radius - 144)), 1e-7);
}

TEST(RailJoint, IsRolledOverAsBruteForceSays) {
  Unevenness what;
  what.joint = {.at = 100, .gap = 6, .step = 0.5, .dip = 3, .dip_length = 600};
  for (what.along = 40; what.along < 160; what.along += 17)
    EXPECT_NEAR(lowered(what), lowered_by_brute_force(what), 1e-6) << what.along;
}

TEST(RailJoint, MovedWithTheWheelIsTheSame) {
  Unevenness what, moved;
  what.joint = {.at = 10, .step = 0.3, .dip = 2, .dip_length = 500};
  moved = what;
  moved.joint.at += 1234.5;
  moved.along += 1234.5;
  EXPECT_NEAR(lowered(what), lowered(moved), 1e-9);
}

TEST(RailJoint, HasNoRailInItsGap) {
  Unevenness what;
  what.joint = {.gap = 10};
  WheelOnRail pair = crowned_wheel(what);
  const TouchPoint touch = lower_to_touch(pair).front();
  EXPECT_NEAR(touch.x, 0, 1e-6); // the middle of both edges
  const CurvePoint top = pair.rail_at(touch.rail_s);
  const std::vector<ContactRow> rows{{top.s, top.position, top.delta}};
  const std::vector<double> gap = undeformed_distance(pair, rows, std::vector<double>{-6, 0, 4.9, 6});
  EXPECT_LT(gap[0], 1);
  EXPECT_EQ(gap[1], excluded_gap);
  EXPECT_EQ(gap[2], excluded_gap);
  EXPECT_NEAR(gap[0], gap[3], 1e-9);
}

/// However wide the gap, the wheel stands on both of its edges, as all of its points say.
TEST(RailJoint, BearsTheWheelOverAWideGap) {
  for (const double gap : {30.0, 87.0, 88.0, 100.0, 120.0}) {
    Unevenness what;
    what.joint = {.gap = gap, .rounding = 2};
    EXPECT_NEAR(lowered(what), lowered_by_brute_force(what), 1e-4) << gap;
  }
}

/// A real pair, yawed, on tread and flange: over all points of the wheel, at each the height of the rail.
TEST(Unevenness, OfAYawedWheelTouchesWhereBruteForceTouches) {
  const TabulatedProfile rail(named_profile("60E1", ProfileKind::rail)),
      wheel(named_profile("S1002", ProfileKind::wheel));
  for (const double lateral : {0.0, 3.0, 6.5}) {
    WheelsetPosition position;
    position.rail_inclination = 0.025;
    position.lateral = lateral;
    position.yaw = 0.01;
    position.uneven.polygon = {{25}, {0.04}, {0.1}};
    position.uneven.joint = {.at = 20, .dip = 2, .dip_length = 400};
    WheelOnRail pair = place(position, rail, wheel);
    const double before = pair.wheel_pose.origin.z;
    const WheelFrame frame = pair.wheel_frame();
    const RailHeight height(pair);
    int near = 0;
    double least = std::numeric_limits<double>::infinity();
    for (double s = wheel.s_begin(); s < wheel.s_end(); s += 0.1) {
      const Point2 p = wheel.at(s).position;
      for (double theta = -0.15; theta < 0.15; theta += 1e-3) {
        const double r = radius + p.z - pair.uneven->depth(theta);
        const auto at = [&](int i) {
          return frame.centre[i] + p.y * frame.axle[i] +
                 r * (std::cos(theta) * frame.down[i] + std::sin(theta) * frame.forward[i]);
        };
        if (const auto h = height.at(at(1), near))
          least = std::min(least, h->z + pair.uneven->rail(at(0)) - at(2));
      }
    }
    lower_to_touch(pair);
    EXPECT_NEAR(pair.wheel_pose.origin.z - before, least, 2e-4) << lateral; // steps of 0.1 and 0.5 mm
    EXPECT_LT(pair.wheel_pose.origin.z - before, least + 1e-6) << lateral;
  }
}

/// While the wheel stands on an edge of its flat it turns about that edge: nothing there moves along the
/// normal, and on an inclined row nothing slides sideways.
TEST(Unevenness, RisesAsItRollsOverAnEdge) {
  WheelOnRail pair = crowned_wheel(new_flat(60, 0.02));
  const TouchPoint touch = lower_to_touch(pair).front();
  ASSERT_GT(std::abs(touch.x), 5);
  const ContactRow inclined{touch.rail_s + 1, touch.position, -0.8};
  const ReferencePoint reference{touch.position, touch.rail_s, -0.8, touch.x, touch.ahead};
  const RigidSlip slip = rigid_slip(pair, reference, {}, std::vector{inclined}, std::vector{touch.x});
  EXPECT_NEAR(slip.x[0], 0, 1e-12);
  EXPECT_NEAR(slip.s[0], 0, 1e-12);
  pair.uneven.reset();
  const RigidSlip round = rigid_slip(pair, reference, {}, std::vector{inclined}, std::vector{touch.x});
  EXPECT_NEAR(round.s[0], std::sin(-0.8) * touch.x / radius, 2e-4);
}

TEST(Unevenness, DoesNotStandOnARoller) {
  WheelsetPosition position;
  position.roller_radius = 500;
  position.uneven.flat.length = 40;
  EXPECT_THROW(
      place(position, named_profile("60E1", ProfileKind::rail), named_profile("S1002", ProfileKind::wheel)),
      InputError);
}

} // namespace
