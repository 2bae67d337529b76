// Bodies placed by their structures' motion. The influence files that are shipped: rail held at its foot,
// wheel at its bore.
#include "bem_contact/sequence/sequence.hpp"

#include "bem_contact/influence/influence_file.hpp"
#include "bem_contact/scene/contact_setup.hpp"
#include "tests/base/message.hpp"
#include "tests/influence/sample_function.hpp"
#include "tests/sanitized.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

namespace {

using namespace bem_contact;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string files = CONFORMAL_SOURCE_DIR "/data/influence/";

const std::string coarse = "grid.dx = 1.0\ngrid.ds = 0.5\n";

/// S1002 on 60E1 at the gauge corner, without friction; on coarse elements unless `more` has others.
SceneFile gauge_corner(double force, const std::string& structural, const std::string& more = "",
                       const std::string& rail = files + "small_rail.h5",
                       const std::string& wheel = files + "small_wheel.h5") {
  SceneFile scene = parse_scene_file(fmt::format(
      "rail.profile = '60E1'\nwheel.profile = 'S1002'\nrail.influence = '{}'\nwheel.influence = '{}'\n"
      "rail.structural = '{}'\nwheel.structural = '{}'\n"
      "load.force = {}\nposition.lateral = 6.6\n{}{}",
      rail, wheel, structural, structural, force, more.find("grid.") == std::string::npos ? coarse : "",
      more));
  scene.motion.frictionless = true;
  return with_model(scene, Model::fem);
}

const std::string linear = "solver.structural_motion = 'linear'\n";

SceneResult solved(const SceneFile& scene) {
  SceneResult out = Sequence().solve(scene);
  EXPECT_TRUE(out.result.certified());
  return out;
}

/// The same file with another table of the remote section's motions.
std::string with_remote(const TemporaryFolder& folder, const std::string& name, double factor) {
  InfluenceFunction f = read_influence_file(files + name);
  for (double& value : f.remote)
    value *= factor;
  const std::string out = folder / name;
  write_influence_file(out, f);
  return out;
}

TEST(StructuralMotion, StandsWhereItsOwnForceTakesIt) {
  const SceneResult r = solved(gauge_corner(5e4, "included"));
  ASSERT_TRUE(r.structure && r.structure->rail && r.structure->wheel);
  const StructuralResult& s = *r.structure;
  EXPECT_TRUE(s.placed);
  EXPECT_LT(s.change, 1e-4);
  EXPECT_GT(s.solutions, 1);
  for (const auto& [body, sign] : {std::pair(*s.rail, 1.0), std::pair(*s.wheel, -1.0)}) {
    EXPECT_NEAR(body.force[1], sign * r.result.totals.Fy, 1e-6 * r.result.totals.Fz);
    EXPECT_NEAR(body.force[2], sign * r.result.totals.Fz, 1e-6 * r.result.totals.Fz);
    const SixNumbers motion = product(body.compliance, body.force);
    for (int i = 0; i < 6; ++i)
      EXPECT_DOUBLE_EQ(motion[i], body.motion[i]);
    EXPECT_NEAR(body.after.y - body.before.y, body.motion[1], 1.1e-4);
  }
  EXPECT_NEAR(s.rail->after.z - s.rail->before.z, s.rail->motion[2], 1.1e-4);
  // Pressed outwards, the rail goes there and the wheel goes the other way. Each force does work on its body.
  EXPECT_GT(s.rail->motion[1], 0);
  EXPECT_LT(s.wheel->motion[1], 0);
  for (const BodyMotion& body : {*s.rail, *s.wheel})
    EXPECT_GT(std::inner_product(body.force.begin(), body.force.end(), body.motion.begin(), 0.0), 0);
}

TEST(StructuralMotion, IsTheLinearSolutionToSecondOrder) {
  // What placing the bodies changes is of second order in the force: relative to the force, of first.
  const auto difference = [](double force) {
    const std::string grid = "grid.dx = 0.5\ngrid.ds = 0.25\n";
    const SceneResult placed = solved(gauge_corner(force, "included", grid));
    const SceneResult undeformed = solved(gauge_corner(force, "included", grid + linear));
    EXPECT_FALSE(undeformed.structure->placed);
    return std::abs(placed.result.totals.Fy - undeformed.result.totals.Fy) / undeformed.result.totals.Fy;
  };
  const double small = difference(1000), middle = difference(2000), large = difference(16000);
  EXPECT_LT(small, 2e-3);
  EXPECT_LT(small, 0.6 * middle);
  EXPECT_LT(middle, large / 5);
}

TEST(StructuralMotion, AStructureThatDoesNotGiveWayChangesNothing) {
  const TemporaryFolder folder;
  const std::string rail = with_remote(folder, "small_rail.h5", 0);
  const std::string wheel = with_remote(folder, "small_wheel.h5", 0);
  const SceneResult placed = solved(gauge_corner(5e4, "included", "", rail, wheel));
  const SceneResult undeformed = solved(gauge_corner(5e4, "included", linear, rail, wheel));
  ASSERT_TRUE(placed.structure && placed.structure->rail);
  EXPECT_FALSE(placed.structure->rail->stiffness);
  EXPECT_EQ(placed.structure->change, 0);
  EXPECT_NEAR(placed.result.totals.Fy, undeformed.result.totals.Fy, 1e-6 * placed.result.totals.Fz);
  EXPECT_NEAR(placed.result.totals.approach, undeformed.result.totals.approach,
              1e-6 * placed.result.totals.approach);
}

TEST(StructuralMotion, EqualsTheLocalContactOfRigidBodiesInThatPosition) {
  // The same contact asked another way: bodies put by hand where the structures take them, relative to each
  // other, and solved with the local compliance alone.
  const SceneResult placed = solved(gauge_corner(5e4, "included"));
  const StructuralResult& s = *placed.structure;
  const double turn = s.rail->motion[3] - s.wheel->motion[3];
  // The rail turns about the origin of its section, the motion is that of the reference point.
  SceneFile by_hand = gauge_corner(5e4, "removed");
  const ContactSetup setup = set_up_contact(by_hand, read_profiles(by_hand));
  const Point2 arm = s.rail->before - setup.wheel_rail()->pair.rail_pose.origin;
  const double across = s.rail->motion[1] - s.wheel->motion[1];
  const double down = s.rail->motion[2] - s.wheel->motion[2];
  by_hand.position.rail_roll = turn;
  by_hand.position.rail_lateral = across + turn * arm.z;
  by_hand.position.rail_vertical = down - turn * arm.y;
  const SceneResult local = solved(by_hand);
  EXPECT_NEAR(local.result.totals.Fy, placed.result.totals.Fy, 5e-3 * placed.result.totals.Fz);
  EXPECT_NEAR(local.result.totals.pmax, placed.result.totals.pmax, 5e-3 * placed.result.totals.pmax);
  // While on the undeformed position the forces are others altogether.
  const SceneResult removed = solved(gauge_corner(5e4, "removed"));
  EXPECT_GT(std::abs(removed.result.totals.Fy - placed.result.totals.Fy), 2e-2 * placed.result.totals.Fz);
}

/// The same with friction, 0.3.
SceneFile rolling(const std::string& structural, const std::string& more = "") {
  SceneFile scene = gauge_corner(1e5, structural, more);
  scene.motion.frictionless = false;
  return scene;
}

TEST(StructuralMotion, PlacedBodiesRollFreelyWithoutLongitudinalForce) {
  const std::string placed = "solver.contact_motion = 'placed'\n";
  for (const auto& [structural, more] :
       {std::pair{"included", std::string()}, std::pair{"removed", placed}}) {
    // The radius of free rolling is found once as what is reported, once for a prescribed force.
    const SceneResult asked = solved(rolling(structural, more));
    const SceneResult free = solved(rolling(structural, more + "load.force_x = 0\n"));
    ASSERT_TRUE(asked.motion.free_rolling && free.motion.free_rolling && asked.structure->placed)
        << structural;
    EXPECT_GT(std::abs(asked.result.totals.Fx), 500) << "this test would say nothing";
    EXPECT_NEAR(free.result.totals.Fx, 0, 0.1);
    EXPECT_NEAR(asked.motion.free_rolling->rolling_radius, free.motion.free_rolling->rolling_radius, 2e-3)
        << structural;
    // So does a wheel that is given this radius.
    const SceneResult given =
        solved(rolling(structural, more + fmt::format("motion.rolling_radius = {:.9g}\n",
                                                      asked.motion.free_rolling->rolling_radius)));
    EXPECT_NEAR(given.result.totals.Fx, 0, 1e-3 * 0.3 * 1e5) << structural;
    EXPECT_NEAR(given.motion.free_rolling->xi, 0, 1e-5) << structural;
  }
}

TEST(StructuralMotion, CreepageOfPlacedBodiesCountsFromFreeRolling) {
  const std::string driven = "motion.xi = 1e-3\n";
  const SceneResult counted = solved(rolling("included", "motion.from_free_rolling = true\n" + driven));
  EXPECT_NEAR(counted.motion.xi - counted.motion.free_rolling->xi, 1e-3, 1e-6);
  EXPECT_GT(counted.result.totals.Fx, 3000);
  // So does that of a wheel whose rolling radius is given as that of free rolling.
  const SceneResult given =
      solved(rolling("included", driven + fmt::format("motion.rolling_radius = {:.9g}\n",
                                                      counted.motion.free_rolling->rolling_radius)));
  EXPECT_NEAR(counted.result.totals.Fx, given.result.totals.Fx, 3e-3 * given.result.totals.Fx);
  EXPECT_NEAR(counted.result.totals.Fy, given.result.totals.Fy, 1e-3 * given.result.totals.Fz);
}

TEST(StructuralMotion, SurfacesThatSlideUnseenAreWarnedOf) {
  const auto warning = Contains(HasSubstr("the surfaces move past each other by up to"));
  EXPECT_THAT(solved(gauge_corner(8e4, "included", linear)).warnings.texts(), warning);
  EXPECT_THAT(solved(gauge_corner(8e4, "included")).warnings.texts(), Not(warning));
  EXPECT_THAT(solved(gauge_corner(8e4, "removed")).warnings.texts(), Not(warning));
}

TEST(StructuralMotion, APrescribedApproachIsThatOfWhatIsHeld) {
  // The approach found for a force gives that force.
  const SceneResult by_force = solved(gauge_corner(5e4, "included"));
  SceneFile scene = gauge_corner(5e4, "included");
  scene.load.force.reset();
  scene.load.approach = by_force.result.totals.approach;
  const SceneResult by_approach = solved(scene);
  EXPECT_NEAR(by_approach.result.totals.Fz, 5e4, 100);
  EXPECT_NEAR(by_approach.result.totals.Fy, by_force.result.totals.Fy, 200);
  EXPECT_EQ(by_approach.result.totals.approach, by_force.result.totals.approach);
}

TEST(StructuralMotion, ALeftWheelIsTheMirrorImage) {
  const SceneResult right = solved(gauge_corner(5e4, "included"));
  SceneFile mirrored = gauge_corner(5e4, "included", "position.side = 'left'\n");
  mirrored.position.lateral = -6.6;
  const SceneResult left = solved(mirrored);
  EXPECT_EQ(left.result.totals.Fy, right.result.totals.Fy);
  EXPECT_EQ(left.structure->wheel->motion, right.structure->wheel->motion);
}

TEST(StructuralMotion, TheApproachSaysWhatItIsRelativeTo) {
  EXPECT_THAT(solved(gauge_corner(5e4, "removed")).approach_datum, HasSubstr("remote section"));
  const std::string held = solved(gauge_corner(5e4, "included")).approach_datum;
  EXPECT_THAT(held, HasSubstr("rail: where it is held (foot"));
  EXPECT_THAT(held, HasSubstr("wheel: where it is held (bore"));
  EXPECT_THAT(Sequence().solve(with_model(gauge_corner(5e4, "removed"), Model::halfspace)).approach_datum,
              HasSubstr("half-spaces"));
}

const std::string by_contact = "solver.contact_motion = 'placed'\n";

TEST(ContactMotion, CostsWhatExactKinematicsSays) {
  // tools/checks/solid3d_contact, at 1e5 N: 0.87 % more lateral force than with linear kinematics, the
  // surfaces 0.064 mm past each other along s, which is 0.054 mm along y.
  const SceneResult undeformed = solved(gauge_corner(1e5, "removed"));
  const SceneResult placed = solved(gauge_corner(1e5, "removed", by_contact));
  EXPECT_FALSE(undeformed.structure);
  ASSERT_TRUE(placed.structure && placed.structure->shift_y);
  EXPECT_FALSE(placed.structure->rail);
  EXPECT_NEAR(*placed.structure->shift_y, -0.054, 0.002);
  EXPECT_NEAR(placed.result.totals.Fy / undeformed.result.totals.Fy, 1.0087, 1.5e-3);
  EXPECT_LT(placed.structure->change, 1e-4);
}

/// A circle of radius R as profile points, 2 w wide.
void write_circle(const std::filesystem::path& file, double R, double w) {
  std::ofstream out(file);
  for (double y = -w; y <= w; y += 0.25)
    out << fmt::format("{:.9f} {:.9f}\n", y, R - std::sqrt(R * R - y * y));
}

TEST(ContactMotion, ForceLiesOnTheLineOfCentres) {
  // A rail of radius 80 in a wheel's groove of radius 100, lowered onto it where both are inclined by -0.4
  // rad. Frictionless pressure on circles passes through their centres. The wheel's centres form a ring about
  // the axle, which rises by x^2 / (2 * 560) off x = 0.
  const TemporaryFolder folder;
  write_circle(folder / "rail.txt", 80, 45);
  write_circle(folder / "wheel.txt", 100, 55);
  const double across = 20 * std::sin(0.4), down = 20 * std::cos(0.4);
  SceneFile scene = with_model(
      parse_scene_file(fmt::format("rail.profile = '{}'\nrail.place = 'absolute'\nrail.y = 750\n"
                                   "wheel.profile = '{}'\nwheel.place = 'absolute'\nwheel.y = {:.9f}\n"
                                   "load.force = 1e5\ngrid.dx = 0.5\ngrid.ds = 0.2\n{}",
                                   (folder / "rail.txt").string(), (folder / "wheel.txt").string(),
                                   750 + across, by_contact)),
      Model::halfspace);
  scene.motion.frictionless = true;
  /// Fy / Fz over what the line of centres says, less 1.
  const auto off = [&](const SceneResult& r) {
    const ContactGrid& grid = r.problem.grid;
    double rise = 0, sum = 0;
    for (int i = 0; i < grid.size(); ++i) {
      const double x = grid.x(i % grid.mx);
      rise += r.result.pn[i] * x * x / (2 * 560);
      sum += r.result.pn[i];
    }
    return r.result.totals.Fy / r.result.totals.Fz * (down + r.result.totals.approach - rise / sum) / across -
           1;
  };
  EXPECT_NEAR(off(solved(scene)), 0, 3e-4);
  scene.solver.contact_motion = ContactMotion::linear;
  EXPECT_LT(off(solved(scene)), -1e-3);
}

TEST(ContactMotion, IsOfSecondOrder) {
  // With a tenth of the force a slide of about a fifth, so a tenth or less of the effect.
  const auto effect = [](double force) {
    return solved(gauge_corner(force, "removed", by_contact)).result.totals.Fy /
               solved(gauge_corner(force, "removed")).result.totals.Fy -
           1;
  };
  EXPECT_LT(std::abs(effect(1e4)), 0.5 * effect(1e5));
}

TEST(ContactMotion, SlidesNowhereOnTop) {
  // On a horizontal surface the approach is normal to it: nothing slides, nothing changes.
  SceneFile scene = with_model(gauge_corner(5e4, "removed", by_contact), Model::halfspace);
  scene.position.lateral = 0;
  scene.position.rail_inclination = 0;
  const SceneResult placed = solved(scene);
  scene.solver.contact_motion = ContactMotion::linear;
  const SceneResult undeformed = solved(scene);
  EXPECT_LT(std::abs(*placed.structure->shift_y), 0.1 * placed.result.totals.approach);
  EXPECT_NEAR(placed.result.totals.Fy, undeformed.result.totals.Fy, 2e-3 * placed.result.totals.Fz);
}

/// What linear kinematics leaves out is in its stated errors: at given places, and where the lateral force is
/// given.
TEST(ContactMotion, StatedErrorsOfLinearKinematicsCoverIt) {
  NEEDS_NO_SANITIZER();
  struct Place {
    const char* rail;
    double inclination, lateral, force, friction;
  };
  for (const Place& at : {Place{"54E1", 0.025, 6.4644, 62303, 0.1},
                          {"54E1", 0.025, 6.197, 106891, 0.1},
                          {"60E1", 0.025, 6.03, 95567, 0.1}}) {
    const auto solved_with = [&](const std::string& more) {
      return Sequence().solve(parse_scene_file(fmt::format(
          "rail.profile = '{}'\nwheel.profile = 'S1002'\nposition.rail_inclination = {}\n"
          "position.lateral = {}\nload.force = {}\nmotion.friction = {}\nsolver.model = 'halfspace'\n{}",
          at.rail, at.inclination, at.lateral, at.force, at.friction, more)));
    };
    const SceneResult linear = solved_with(""), placed = solved_with(by_contact);
    const std::string force = fmt::format("load.force_y = {:.9g}\n", linear.result.totals.Fy.value + 500);
    const SceneResult linear_by_force = solved_with(force), placed_by_force = solved_with(force + by_contact);
    for (const auto& [a, b] : {std::pair(&linear, &placed), {&linear_by_force, &placed_by_force}})
      for (const auto number : {&ContactTotals::Fx, &ContactTotals::Fy, &ContactTotals::pmax,
                                &ContactTotals::area, &ContactTotals::approach, &ContactTotals::T_gamma}) {
        const Measured &x = a->result.totals.*number, &y = b->result.totals.*number;
        EXPECT_LE(std::abs(x - y), x.error + y.error) << at.rail << ' ' << x.value << ' ' << y.value;
      }
    EXPECT_GT(linear.result.totals.Fy.error, 2 * placed.result.totals.Fy.error);
    EXPECT_GT(linear_by_force.result.totals.pmax.error, 1.2 * placed_by_force.result.totals.pmax.error);
  }
}

TEST(ContactMotion, ALeftWheelIsTheMirrorImage) {
  const SceneFile scene = with_model(gauge_corner(5e4, "removed", by_contact), Model::halfspace);
  SceneFile mirrored = scene;
  mirrored.position.side = WheelSide::left;
  mirrored.position.lateral = -6.6;
  const SceneResult right = solved(scene), left = solved(mirrored);
  EXPECT_EQ(left.result.totals.Fy, right.result.totals.Fy);
  EXPECT_EQ(*left.structure->shift_y, *right.structure->shift_y);
}

TEST(StructuralMotion, WithFrictionTheBodiesStandToo) {
  SceneFile scene = gauge_corner(5e4, "included", "motion.xi = 0.002\n");
  scene.motion.frictionless = false;
  const SceneResult r = solved(scene);
  EXPECT_LT(r.structure->change, 1e-4);
  EXPECT_NEAR(r.structure->rail->force[0], r.result.totals.Fx, 1e-6 * r.result.totals.Fz);
}

} // namespace
