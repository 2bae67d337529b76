#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/conicity/equivalent_conicity.hpp"
#include "bem_contact/uses/conicity/rolling_radius.hpp"
#include "bem_contact/uses/conicity/wheelset_conicity.hpp"
#include "tests/profile/curves.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace {

using namespace bem_contact;

TabulatedProfile cone(double slope, double half_width = 60) {
  const double w = half_width;
  const std::vector<Point2> points{{w, -slope * w}, {0, 0}, {-w / 2, slope * w / 2}, {-w, slope * w}};
  return ProfileCurve::through_points("cone", points);
}

constexpr double rail_radius = 200;

/// The top of a circle, whose centre is `rail_radius` below the origin.
TabulatedProfile round_rail() {
  std::vector<Point2> points;
  for (int i = -200; i <= 200; ++i)
    points.push_back({rail_radius * std::sin(1e-3 * i), rail_radius * (1 - std::cos(1e-3 * i))});
  return ProfileCurve::through_points("circle", points);
}

WheelsetOnTrack wheelset(const TabulatedProfile& rail, const TabulatedProfile& wheel, double cant = 0) {
  return {.right_rail = rail,
          .right_wheel = wheel,
          .left_rail = rail,
          .left_wheel = wheel,
          .position = {.rail_inclination = cant}};
}

TabulatedProfile standard(const char* name, ProfileKind kind) {
  return named_profile(name, kind);
}

/// Without roll a cone touches the rail at the same place wherever it stands: 2 tan gamma y. The search for
/// the touch point knows its place to 1e-5 mm.
TEST(RollingRadius, IsExactForAConeThatStaysUpright) {
  for (const double gamma : {0.025, 0.05, 0.1}) {
    const WheelsetOnTrack w = wheelset(standard("60E1", ProfileKind::rail), cone(gamma));
    std::vector<RadiusDifference> function;
    for (const WheelsetStand& s : rolling_radius_difference(w, 12)) {
      EXPECT_NEAR(s.difference(), 2 * gamma * s.lateral, 1e-6);
      function.push_back({s.lateral, s.difference()});
    }
    const auto found = equivalent_conicity(function, 3, {w.contact_distance(), 460});
    EXPECT_NEAR(found->tan_gamma, gamma, 1e-6);
    EXPECT_DOUBLE_EQ(w.contact_distance(), 1500);
  }
}

/// A rolled cone on a circle touches it where the circle has the cone's inclination. From there follow the
/// rolling radius and the height of the axle, which must be the same for both wheels.
TEST(RollingRadius, IsExactForAConeThatRollsOnRoundRails) {
  const double slope = 0.05, gamma = std::atan(slope), rail_y = 750;
  WheelsetOnTrack w = wheelset(round_rail(), cone(slope));
  w.position.rail_origin = Point2{rail_y, 0};
  w.rolls = true;
  for (const double y : {0.0, 1.0, -4.0, 8.0}) {
    const WheelsetStand s = stand(w, y);
    double height[2], radius[2];
    for (const int side : {0, 1}) { // left: in the mirror
      const double phi = side == 0 ? s.roll : -s.roll, centre = side == 0 ? y : -y, delta = phi - gamma;
      const Point2 touch{rail_y + rail_radius * std::sin(delta) - centre,
                         rail_radius * (1 - std::cos(delta))};
      // The axle goes through (0, z) along (cos phi, sin phi). The radius at `along` is the distance from it.
      const auto radius_at = [&](double z) {
        const double along = touch.y * std::cos(phi) + (touch.z - z) * std::sin(phi);
        return 460 - slope * (along - 750);
      };
      const auto miss = [&](double z) {
        return -touch.y * std::sin(phi) + (touch.z - z) * std::cos(phi) - radius_at(z);
      };
      const double at0 = miss(-460), slope_z = miss(-459) - at0;
      height[side] = -460 - at0 / slope_z;
      radius[side] = radius_at(height[side]);
    }
    EXPECT_NEAR(height[0], height[1], 1e-6) << y;
    EXPECT_NEAR(s.right.radius, radius[0], 1e-5) << y;
    EXPECT_NEAR(s.left.radius, radius[1], 1e-5) << y;
    EXPECT_NEAR(s.right.delta, s.roll - gamma, 1e-6) << y;
  }
}

TEST(RollingRadius, ChangesSignInTheMirror) {
  const TabulatedProfile rail = standard("60E1", ProfileKind::rail);
  const std::filesystem::path folder = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies";
  const TabulatedProfile worn = read_profile(folder / "worn_wheel.txt", ProfileKind::wheel);
  WheelsetOnTrack w = wheelset(rail, standard("S1002", ProfileKind::wheel), 0.025);
  w.left_wheel = worn;
  w.rolls = true;
  WheelsetOnTrack mirrored = w;
  std::swap(mirrored.right_wheel, mirrored.left_wheel);
  for (const double y : {0.0, 1.3, -2.7, 5.1}) {
    const WheelsetStand a = stand(w, y), b = stand(mirrored, -y);
    EXPECT_NEAR(a.difference(), -b.difference(), 1e-6) << y;
    EXPECT_NEAR(a.roll, -b.roll, 1e-9) << y;
    EXPECT_NEAR(a.right.rail_s, b.left.rail_s, 1e-4) << y;
  }
  // Equal sides: an odd function.
  const WheelsetOnTrack even = wheelset(rail, worn, 0.025);
  EXPECT_NEAR(stand(even, 0).difference(), 0, 1e-9);
  EXPECT_NEAR(stand(even, 2.2).difference(), -stand(even, -2.2).difference(), 1e-6);
}

TEST(RollingRadius, IsFineWhereTheContactJumps) {
  const WheelsetOnTrack w =
      wheelset(standard("60E1", ProfileKind::rail), standard("S1002", ProfileKind::wheel));
  const std::vector<WheelsetStand> stands = rolling_radius_difference(w, 8);
  EXPECT_TRUE(std::ranges::is_sorted(stands, {}, &WheelsetStand::lateral));
  EXPECT_NEAR(stands.back().lateral, 8, 1e-12);
  EXPECT_NEAR(stands.front().lateral, -8, 1e-12);
  bool jumped = false;
  for (std::size_t k = 1; k < stands.size(); ++k) {
    const double step = stands[k].lateral - stands[k - 1].lateral;
    EXPECT_LE(step, 0.1 + 1e-12);
    if (std::abs(stands[k].right.wheel_s - stands[k - 1].right.wheel_s) > 2) {
      jumped = true;
      EXPECT_LT(step, 5e-3);
    }
  }
  EXPECT_TRUE(jumped); // from the tread to the flange root
}

TEST(RollingRadius, EndsWhereAWheelLeavesItsRail) {
  const std::vector<WheelsetStand> stands =
      rolling_radius_difference(wheelset(standard("60E1", ProfileKind::rail), cone(0.05, 20)), 45);
  EXPECT_NEAR(stands.back().lateral, 20, 16); // somewhere on the rail's head
  EXPECT_NEAR(stands.front().lateral, -stands.back().lateral, 0.1 + 1e-9);
  EXPECT_THROW(rolling_radius_difference(wheelset(round_rail(), cone(0.05)), 0), InputError);
}

TEST(RollingRadius, TakesTheWheelsetOfAScene) {
  const SceneFile scene =
      parse_scene_file("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 1e5\n"
                       "position.rail_inclination = 0.025\nposition.lateral = 3\nposition.roll = 0.01\n");
  const WheelsetOnTrack same = wheelset_of(scene);
  EXPECT_EQ(same.left_wheel.digest(), same.right_wheel.digest());
  EXPECT_NEAR(stand(same, 0).difference(), 0, 1e-9); // neither displacement nor roll of the scene count
  const WheelsetOnTrack other = wheelset_of(scene, {.rail = "54E1", .wheel = ""});
  EXPECT_EQ(other.left_rail.name(), "54E1");
  EXPECT_EQ(other.right_rail.name(), "60E1");
  EXPECT_THROW(wheelset_of(parse_scene_file("rail.profile = '60E1'\nwheel.profile = 'S1002'\nload.force = 1\n"
                                            "wheel.flat.depth = 0.5\n")),
               InputError);
  EXPECT_THROW(wheelset_of(parse_scene_file("kind = \"patch\"\nload.force = 1\ngrid.mx = 2\ngrid.ms = 2\n")),
               InputError);
}

} // namespace
