#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/sequence/compare_quantities.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace {

using namespace bem_contact;

SceneResult solved(const std::string& toml, Model model = Model::halfspace) {
  return Sequence().solve(with_model(parse_scene_file(toml), model));
}

double of(const SceneResult& r, std::string_view name, std::size_t patch = 0) {
  for (const PatchQuantity& q : patch_quantities())
    if (name == q.name)
      return q.value(r, patch);
  ADD_FAILURE() << name;
  return 0;
}

/// Relative radii 460 mm along x and 300 mm along s, under 1e5 N of steel: semi-axes by Hertz 7.1617 and
/// 5.3872 mm (data/scenes/hertz.toml).
constexpr double long_axis = 7.1617, short_axis = 5.3872;
std::string ellipse(double angle, double d = 0.4) {
  const double a = 1 / 920.0, b = 1 / 600.0, c = std::cos(angle), s = std::sin(angle);
  const int n = static_cast<int>(std::lround(16 / d));
  return fmt::format("kind = 'patch'\nload.force = 1e5\nmotion.frictionless = "
                     "true\n[rail.material]\nshear_modulus = 80769.2308\n"
                     "poisson = 0.3\n[wheel.material]\nshear_modulus = 80769.2308\npoisson = 0.3\n[grid]\ndx "
                     "= {0}\nds = {0}\nmx = "
                     "{1}\nms = {1}\n[gap]\na = {2}\nb = {3}\nc = {4}\n",
                     d, n, a * c * c + b * s * s, a * s * s + b * c * c, (a - b) * 2 * c * s);
}

/// The error falls faster than the size of the elements; 13, 27 and 54 of them lie across the patch.
TEST(PatchQuantities, TheEllipseIsThatOfHertz) {
  for (const auto& [d, bar] : {std::pair{0.8, 2e-3}, {0.4, 1e-3}, {0.2, 2e-4}}) {
    const SceneResult r = solved(ellipse(0, d));
    EXPECT_NEAR(of(r, "semi_axis_a") / long_axis, 1, bar) << d;
    EXPECT_NEAR(of(r, "semi_axis_b") / short_axis, 1, bar) << d;
  }
}

/// The long axis is given the angle -0.5, -0.2, ... from x towards s. At 1.2 it is nearer to s.
TEST(PatchQuantities, TheEllipseTurnsWithTheBodies) {
  for (const Model model : {Model::halfspace, Model::hertz})
    for (const double angle : {-0.5, 0.2, 0.7}) {
      const SceneResult r = solved(ellipse(angle), model);
      EXPECT_NEAR(of(r, "axis_angle"), angle, 0.005) << angle;
      EXPECT_NEAR(of(r, "semi_axis_a") / long_axis, 1, 2e-3) << angle;
      EXPECT_NEAR(of(r, "semi_axis_b") / short_axis, 1, 2e-3) << angle;
    }
  for (const Model model : {Model::halfspace, Model::hertz}) {
    const SceneResult across = solved(ellipse(1.2), model);
    EXPECT_NEAR(of(across, "axis_angle"), 1.2 - std::numbers::pi / 2, 0.005);
    EXPECT_NEAR(of(across, "semi_axis_a") / short_axis, 1, 2e-3);
  }
}

/// Parallel cylinders in plane strain: half width by Hertz b = sqrt(4 F R / (pi E*)).
TEST(PatchQuantities, InPlaneStrainTheOtherAxisIsAHalfWidth) {
  const SceneResult r = solved(
      "kind = 'patch'\nload.force = 1000\nmotion.frictionless = true\n[grid]\ndx = 1\nds = 0.02\n"
      "mx = 1\nms = 200\nplane_strain = true\n[gap]\nb = 2.5e-3\n[rail.material]\n"
      "shear_modulus = 80000\npoisson = 0.25\n[wheel.material]\nshear_modulus = 80000\npoisson = 0.25\n");
  const double modulus = 80000 / (1 - 0.25), radius = 200;
  EXPECT_NEAR(of(r, "semi_axis_b") / std::sqrt(4 * 1000 * radius / (std::numbers::pi * modulus)), 1, 1e-3);
  EXPECT_TRUE(std::isnan(of(r, "semi_axis_a")));
}

/// A yawed and rolled wheel on a worn rail: one patch on the tread and one at the flange.
constexpr double roll = 0.0027909;
SceneResult two_patches() {
  SceneFile scene = parse_scene_file(fmt::format(
      "rail.profile = \"worn_rail.txt\"\nwheel.profile = \"worn_wheel.txt\"\nload.force = 5690.41\n"
      "position.lateral = 9.77934\nposition.yaw = 0.0108345\nposition.roll = {}\nmotion.xi = 1e-3\n"
      "motion.friction = 0.24\n[grid]\ndx = 0.2\nds = 0.12\n",
      roll));
  scene.folder = std::filesystem::path(CONFORMAL_SOURCE_DIR) / "data/bodies";
  return Sequence().solve(with_model(scene, Model::halfspace));
}

TEST(PatchQuantities, SumsOverPatchesAreTheTotals) {
  const SceneResult r = two_patches();
  ASSERT_GE(r.result.patches.size(), 2u);
  const auto sum = [&](std::string_view name) {
    double total = 0;
    for (std::size_t i = 0; i < r.result.patches.size(); ++i)
      total += of(r, name, i);
    return total;
  };
  for (const char* force : {"Fx", "Fy", "Fz"})
    EXPECT_NEAR(sum(force), quantity(force).value(r), 1e-9 * r.result.totals.Fz) << force;
  for (const char* number : {"area", "T_gamma", "contact", "adhesion", "slip"})
    EXPECT_NEAR(sum(number), quantity(number).value(r), 1e-9 * quantity(number).value(r)) << number;
  // About z through the origin: M_s sin(delta) + M_n cos(delta) of the moment, and the force at its centre.
  double mz = 0;
  for (std::size_t i = 0; i < r.result.patches.size(); ++i)
    mz += of(r, "Ms", i) * std::sin(of(r, "delta", i)) + of(r, "Mn", i) * std::cos(of(r, "delta", i)) +
          of(r, "x", i) * of(r, "Fy", i) - of(r, "y", i) * of(r, "Fx", i);
  EXPECT_NEAR(mz, r.result.totals.Mz, 1e-9 * std::abs(r.result.totals.Mz));
}

/// The top of 60E1 is an arc of radius 300 mm about its axis; inclined by 1:40 a wheel touches it there.
TEST(PatchQuantities, ATreadContactLiesOnTheRailsArcAndOnTheWheelsProfile) {
  constexpr double cant = 0.025;
  const SceneResult r =
      solved("rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 2e4\n"
             "position.rail_inclination = 0.025\nmotion.xi = 1e-3\n[grid]\ndx = 0.3\nds = 0.3\n");
  ASSERT_EQ(r.result.patches.size(), 1u);
  const double s = of(r, "s"), y = of(r, "rail_y");
  ASSERT_LT(std::abs(y), 10);
  EXPECT_NEAR(y, 300 * std::sin(s / 300), 1e-6);
  EXPECT_NEAR(of(r, "rail_z"), 300 * (1 - std::cos(s / 300)), 1e-6);
  EXPECT_NEAR(of(r, "delta"), s / 300 - cant, 1e-6);
  // The track frame turns the profile by the cant, about the origin that stands at (y0, z0).
  const double c = std::cos(cant), d = std::sin(cant);
  const double y0 = of(r, "y") - (c * y + d * of(r, "rail_z")),
               z0 = of(r, "z") - (c * of(r, "rail_z") - d * y);
  const ContactRow& row = *std::ranges::min_element(
      r.problem.rows, {}, [&](const ContactRow& other) { return std::abs(other.s - s + 2); }); // 2 mm beside
  const double at = row.s / 300;
  EXPECT_NEAR(row.position.y, y0 + 300 * (c * std::sin(at) + d * (1 - std::cos(at))), 1e-4);
  EXPECT_NEAR(row.position.z, z0 + 300 * (c * (1 - std::cos(at)) - d * std::sin(at)), 1e-4);
  const ProfileCurve wheel = standard_profile("S1002");
  const CurvePoint opposite = wheel.at(of(r, "wheel_s"));
  EXPECT_NEAR(of(r, "wheel_y"), opposite.position.y, 1e-9);
  EXPECT_NEAR(of(r, "wheel_z"), opposite.position.z, 1e-9);
  // The bodies touch where their normals agree; under load within a fraction of a degree.
  EXPECT_NEAR(of(r, "wheel_delta"), of(r, "delta"), 3e-3);
  // Both are seen from the axle: y of the wheel's point is that of the rail's, less where the tape circle is.
  EXPECT_NEAR(of(r, "wheel_y") + 1360 / 2.0 + 70, of(r, "y"), 0.02);
}

TEST(PatchQuantities, CreepagesAreThoseAtThePatch) {
  const SceneResult flat =
      solved("kind = 'patch'\nload.force = 1e4\n[motion]\nxi = 1e-3\neta = -5e-4\nphi = 2e-4\n"
             "[grid]\ndx = 0.5\nds = 0.5\nmx = 24\nms = 20\n[gap]\na = 1e-3\nb = 1e-3\n");
  EXPECT_NEAR(of(flat, "xi"), 1e-3 - 2e-4 * of(flat, "s"), 1e-12);
  EXPECT_NEAR(of(flat, "eta"), -5e-4 + 2e-4 * of(flat, "x"), 1e-12);
  EXPECT_NEAR(of(flat, "phi"), 2e-4, 1e-12);
  EXPECT_NEAR(flat.motion.xi, 1e-3, 1e-15);
  EXPECT_NEAR(flat.motion.eta, -5e-4, 1e-15);
  // A force is prescribed: the creepage found is in both.
  const SceneResult found =
      solved("kind = 'patch'\nload.force = 1e4\nload.force_x = 1000\n[motion]\nxi = 1e-3\n"
             "[grid]\ndx = 0.5\nds = 0.5\nmx = 24\nms = 20\n[gap]\na = 1e-3\nb = 1e-3\n");
  EXPECT_NEAR(of(found, "xi"), 1e-3 + found.result.totals.creepage_x, 1e-12);
  EXPECT_EQ(found.motion.xi, 1e-3 + found.result.totals.creepage_x);
  // A rolling wheel spins over an inclined rail by sin(delta) / R.
  const SceneResult two = two_patches();
  for (std::size_t i = 0; i < two.result.patches.size(); ++i) {
    const double radius = 460 + of(two, "wheel_z", i);
    EXPECT_NEAR(of(two, "phi", i) / (std::sin(of(two, "delta", i) - roll) / radius), 1, 0.02) << i;
  }
  const SceneResult frictionless = solved(ellipse(0));
  EXPECT_TRUE(std::isnan(of(frictionless, "xi")));
}

TEST(Quantities, ANameHasOneUnit) {
  std::map<std::string, std::string> units;
  const auto take = [&](const auto& table) {
    std::map<std::string, int> names;
    for (const auto& q : table) {
      EXPECT_EQ(names[q.name]++, 0) << q.name;
      EXPECT_EQ(units.try_emplace(q.name, q.unit.text()).first->second, q.unit.text()) << q.name;
    }
  };
  take(quantities());
  take(patch_quantities());
  take(step_quantities());
  take(row_quantities());
  take(element_quantities());
}

/// Python's type of a number follows from its row. A patch without friction has the fewest numbers.
TEST(Quantities, OnlyWhatMayBeMissingIsMissing) {
  const SceneResult r = solved(ellipse(0));
  std::size_t missing = 0;
  for (const Quantity& q : quantities()) {
    EXPECT_TRUE(q.missing == Missing::possible || !std::isnan(q.value(r))) << q.name;
    missing += q.missing == Missing::possible && std::isnan(q.value(r));
  }
  EXPECT_GE(missing, 5u); // no displacement, temperatures, free rolling and layer
}

TEST(Quantities, DifferencesBeyondTheCertificateAreFound) {
  const SceneResult r = solved(ellipse(0));
  std::map<std::string, double> before;
  for (const Quantity& q : quantities())
    before[q.name] = q.value(r);
  EXPECT_TRUE(differing_quantities(before, r).empty());
  before["Fz"] += 0.09; // of 1e5 N, and 0.1 N are allowed
  before["outer_iterations"] += 1;
  EXPECT_TRUE(differing_quantities(before, r).empty());
  before["Fx"] = 0.11;
  before["contact"] -= 1;
  before["lateral"] = 0; // a patch has none
  const auto found = differing_quantities(before, r);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_STREQ(found[0].quantity->name, "Fx");
  EXPECT_NEAR(found[0].allowed, 0.1, 1e-6);
  EXPECT_STREQ(found[1].quantity->name, "lateral");
  EXPECT_STREQ(found[2].quantity->name, "contact");
}

} // namespace
