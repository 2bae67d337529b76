#include "bem_contact/geometry/conformity.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "tests/geometry/shapes.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace bem_contact {
namespace {

/// Along the normal at the angle phi from the touching point, from a circle of radius r to one of radius R
/// around it that touches it there.
double between_circles(double r, double R, double phi) {
  const double d = R - r;
  return std::sqrt(R * R - std::pow(d * std::sin(phi), 2)) - d * std::cos(phi) - r;
}

/// Where that distance is `h`.
double angle_at(double r, double R, double h) {
  double low = 0, high = 1.5;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (between_circles(r, R, middle) < h ? low : high) = middle;
  }
  return low;
}

Conformity of_arcs(double r, double R, double gauge_height) {
  WheelOnRail pair = shapes::arcs(r, -R, 460, 1.2);
  const TouchPoint touch = lower_to_touch(pair).front();
  return conformity(pair, touch, gauge_height);
}

/// The gauge point is at the angle where the rail's circle is so deep below its top.
TEST(Conformity, OfTwoArcsIsThatOfTwoCircles) {
  const double r = 13;
  for (const double R : {13.2, 14.0, 20.0}) {
    const double depth = 6, phi = std::acos(1 - depth / r);
    const Conformity c = of_arcs(r, R, depth);
    EXPECT_NEAR(c.end_s, -r * phi, 2e-4) << R; // chords between the nodes of the table
    EXPECT_NEAR(c.largest, between_circles(r, R, phi), 2e-5) << R;
    EXPECT_NEAR(c.largest_s, c.end_s, 1e-12) << R;
    const double half = angle_at(r, R, 0.1);
    EXPECT_NEAR(c.width, 2 * r * std::min(half, 1.2), 2e-3) << R;
    EXPECT_NEAR(c.turn, 2 * std::min(half, 1.2), 2e-4) << R;
    EXPECT_NEAR(c.rail_radius, r, 1e-3) << R;
    EXPECT_NEAR(c.wheel_radius, -R, 0.02) << R;
    EXPECT_NEAR(c.ratio(), r / R, 1e-3) << R;
  }
}

TEST(Conformity, HasTheClassesOfItsLargestDistance) {
  EXPECT_EQ(of_arcs(13, 13.2, 6).fit(), Fit::closely_conformal); // 0.09 mm
  EXPECT_EQ(of_arcs(13, 13.8, 6).fit(), Fit::conformal);         // 0.35 mm
  EXPECT_EQ(of_arcs(13, 20.0, 6).fit(), Fit::not_conformal);
  EXPECT_EQ(of_arcs(300, 330, 6).fit(), Fit::closely_conformal); // 20 mm of it: 0.06 mm
}

/// A rail that is longer than 20 mm from the touching point to the gauge point is looked at over 20 mm.
TEST(Conformity, LooksOverAtMostTwentyMillimetres) {
  const Conformity c = of_arcs(300, 330, 6);
  EXPECT_NEAR(c.end_s, -20, 1e-6);
  EXPECT_NEAR(c.largest, between_circles(300, 330, 20.0 / 300), 1e-6);
}

/// S1002 on an upright 60E1 touches at two places: beyond the displacement it touches on the flange, before
/// it on the tread; there both distances are 0.
TEST(Conformity, AtTheFlangeIsWhereTheContactGoesToIt) {
  const TabulatedProfile rail = standard_profile("60E1"), wheel = standard_profile("S1002");
  for (const WheelSide which : {WheelSide::right, WheelSide::left}) {
    const double side = which == WheelSide::right ? 1 : -1;
    WheelsetPosition position{.side = which, .yaw = 0.01};
    const auto at = conformity_at_flange(position, rail, wheel);
    ASSERT_TRUE(at);
    position.yaw = 0;
    const auto inclination = [&](double lateral) {
      position.lateral = lateral;
      WheelOnRail pair = place(position, rail, wheel);
      return lower_to_touch(pair).front().delta;
    };
    EXPECT_GT(inclination(at->lateral), -0.62); // 35 degrees, half of S1002's 70
    EXPECT_LT(inclination(at->lateral + side * 2e-6), -0.60);
    EXPECT_GT(at->width, 1);
    EXPECT_LT(at->end_s, at->rail_s);
  }
}

} // namespace
} // namespace bem_contact
