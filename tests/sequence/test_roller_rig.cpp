#include "bem_contact/reference/hertz.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/base/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

namespace {

using namespace bem_contact;

/// Two equal discs of radius 200 mm, their crowns of radius 120 mm.
class RollerRig : public ::testing::Test {
protected:
  static constexpr double disc = 200, crown = 120, force = 8e3;

  RollerRig() {
    std::ofstream rail(folder_.path() / "roller.txt"), wheel(folder_.path() / "disc.txt");
    for (int i = -200; i <= 200; ++i) {
      const double a = 0.15 * i / 200, y = crown * std::sin(a), z = crown * (1 - std::cos(a));
      rail << fmt::format("{:.15g} {:.15g}\n", y, z);
      wheel << fmt::format("{:.15g} {:.15g}\n", -y, -z);
    }
  }
  SceneFile scene(const std::string& more, double roller_radius = disc) {
    const std::string body = "place = 'absolute', y = 700, z = 0, profile_z = 'down'";
    return parse_scene_file(
        SceneText(fmt::format("rail = {{ profile = 'roller.txt', {0}, roller_radius = {1} }}\n"
                              "wheel = {{ profile = 'disc.txt', {0} }}\nposition.wheel_radius = {2}\n"
                              "load.force = {3}\ngrid = {{ dx = 0.15, ds = 0.15 }}\n{4}",
                              body, roller_radius, disc, force, more),
                  "rig.toml", folder_.path()));
  }
  TemporaryFolder folder_;
};

TEST_F(RollerRig, TwoEqualDiscsAreHertz) {
  const Material steel;
  const reference::HertzContact exact =
      reference::hertz_by_force(1 / disc, 1 / crown, reference::contact_modulus(steel, steel), force);
  for (const char* model : {"hertz", "halfspace", "tangent_plane"}) {
    const SceneResult r =
        Sequence().solve(scene(fmt::format("motion.frictionless = true\nsolver.model = '{}'\n", model)));
    ASSERT_TRUE(r.result.certified()) << model;
    ASSERT_EQ(r.result.patches.size(), 1u) << model;
    const PatchSummary& patch = r.result.patches.front();
    EXPECT_NEAR(patch.pmax, exact.max_pressure, 5e-3 * exact.max_pressure) << model;
    EXPECT_NEAR(r.result.totals.approach, exact.approach, 5e-3 * exact.approach) << model;
    EXPECT_NEAR(patch.area, std::numbers::pi * exact.semi_axis_x * exact.semi_axis_s, 0.03 * patch.area)
        << model;
  }
}

/// Discs of one speed roll freely; a faster roller drags the wheel along, as a wheel that brakes is dragged
/// by a rail.
TEST_F(RollerRig, TheRollersSpeedMakesTheCreepage) {
  const std::string rolling = "motion.friction = 0.3\nmotion.speed = 2e3\nsolver.model = 'halfspace'\n";
  const auto solved = [&](const std::string& more) { return Sequence().solve(scene(rolling + more)); };
  const SceneResult free = solved("");
  // Rigid slip and rolling radius are taken on the undeformed roller, as far from the wheel as the gap h
  // there: they are off by some h / R, on a track too.
  ASSERT_TRUE(free.motion.free_rolling);
  EXPECT_LT(std::abs(free.motion.free_rolling->xi), 0.5 * free.result.totals.approach / disc);
  // v_r = 2010, v_w = 1990 mm/s: 20 over the mean of 2000.
  const SceneResult fast = solved("motion.pitch_rate = 9.95\nmotion.roller_speed = 10.05\n");
  const SceneResult given = solved("motion.xi = 0.01\n");
  EXPECT_NEAR(fast.patch_places.front().xi, 0.01, 1e-6);
  EXPECT_NEAR(fast.result.totals.Fx, given.result.totals.Fx, 1e-5 * force);
  EXPECT_GT(fast.result.totals.Fx, 0.25 * force);
  const SceneResult slow = solved("motion.pitch_rate = 10.05\nmotion.roller_speed = 9.95\n");
  EXPECT_NEAR(slow.result.totals.Fx, -fast.result.totals.Fx, 1e-4 * force);
  // A yawed disc slides sideways as on a track.
  EXPECT_NEAR(solved("position.yaw = 3e-3\n").patch_places.front().eta, -3e-3, 1e-5);
}

/// Whatever the rolling radius from which creepage is counted: a wheel that is given the radius of free
/// rolling rolls freely.
TEST_F(RollerRig, AWheelRollsFreelyWithTheRadiusThatIsStated) {
  const std::string rolling = "motion.friction = 0.3\nsolver.model = 'halfspace'\n";
  for (const double radius : {196.0, 200.0, 204.0}) {
    const auto solved = [&](double r) {
      return Sequence().solve(scene(rolling + fmt::format("motion.rolling_radius = {:.9g}\n", r)));
    };
    const SceneResult asked = solved(radius);
    ASSERT_TRUE(asked.motion.free_rolling);
    const FreeRolling& free = *asked.motion.free_rolling;
    const SceneResult given = solved(free.rolling_radius);
    ASSERT_TRUE(given.motion.free_rolling);
    EXPECT_NEAR(given.motion.free_rolling->rolling_radius, free.rolling_radius, 2e-6 * disc) << radius;
    EXPECT_NEAR(given.motion.free_rolling->xi, 0, 1e-5) << radius;
    // The same creepage without that radius.
    const SceneResult by_creepage =
        Sequence().solve(scene(rolling + fmt::format("motion.rolling_radius = {:.9g}\nmotion.xi = {:.9g}\n",
                                                     radius, free.xi.value)));
    EXPECT_NEAR(by_creepage.result.totals.Fx, given.result.totals.Fx, 1e-3 * force) << radius;
  }
}

TEST_F(RollerRig, TheRadiusOfFreeRollingOnALargeRollerIsThatOnTheTrack) {
  const std::string rolling =
      "motion = { friction = 0.3, rolling_radius = 197 }\nsolver.model = 'halfspace'\n";
  const SceneResult track = Sequence().solve(scene(rolling, 0)),
                    roller = Sequence().solve(scene(rolling, 1e6));
  ASSERT_TRUE(roller.motion.free_rolling && track.motion.free_rolling);
  EXPECT_NEAR(roller.motion.free_rolling->rolling_radius, track.motion.free_rolling->rolling_radius,
              1e-5 * disc);
}

TEST_F(RollerRig, ALargeRollerIsTheTrack) {
  const std::string rolling =
      "motion = { friction = 0.3, xi = 1e-3 }\nposition.yaw = 2e-3\nsolver.model = 'halfspace'\n";
  const SceneResult track = Sequence().solve(scene(rolling, 0)),
                    roller = Sequence().solve(scene(rolling, 1e6));
  EXPECT_NEAR(roller.result.totals.Fx, track.result.totals.Fx, 5e-4 * force);
  EXPECT_NEAR(roller.result.totals.Fy, track.result.totals.Fy, 5e-4 * force);
  EXPECT_NEAR(roller.result.totals.approach, track.result.totals.approach,
              5e-4 * track.result.totals.approach);
  ASSERT_TRUE(roller.motion.free_rolling && track.motion.free_rolling);
  EXPECT_NEAR(roller.motion.free_rolling->rolling_radius, track.motion.free_rolling->rolling_radius, 1e-3);
}

} // namespace
