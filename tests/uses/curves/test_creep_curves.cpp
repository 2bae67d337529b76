#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fmt/core.h>

namespace {

using namespace bem_contact;
using ::testing::HasSubstr;

constexpr std::size_t Fx = 0, Fs = 1, Mz = 2, xi = 0, eta = 1, phi = 2;

/// A Hertz contact with about `across` elements along each axis: a = 2.8, b = 1.8 mm where curvature_s =
/// 2e-3, a circle where it is 1e-3.
SceneFile hertz(int across, double curvature_s = 2e-3, const std::string& more = "") {
  const double wide = curvature_s > 1e-3 ? 3.8 : 4.9, length = curvature_s > 1e-3 ? 5.9 : 4.9;
  const int n = across + 4 + across % 2;
  return parse_scene_file(
      fmt::format("kind = \"patch\"\n[load]\nforce = 4000\n[motion]\nfriction = 0.3\n{}[grid]\n"
                  "dx = {}\nds = {}\nmx = {}\nms = {}\n[gap]\na = 1e-3\nb = {}\n",
                  more, length / across, wide / across, n, n, curvature_s));
}

CreepCurves curves(const SceneFile& scene, const std::vector<CreepRange>& ranges = {}) {
  return creep_curves(scene, ranges);
}

/// Largest of the five slopes' differences from Kalker's, relative.
double off(const CreepCurves& c) {
  double worst = 0;
  for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Fs, phi}, {Mz, eta}, {Mz, phi}})
    worst = std::max(worst, std::abs(c.slopes.values[f][k] / c.linear->slopes[f][k] - 1));
  return worst;
}

/// The limit of small creepages is Kalker's linear theory (table E3 of Kalker 1990). Elements of piecewise
/// constant traction converge to it with the first power of their size.
TEST(CreepCurves, SlopesAtZeroGoToKalkersCoefficients) {
  for (const double curvature : {2e-3, 1e-3}) {
    const double coarse = off(curves(hertz(14, curvature))), fine = off(curves(hertz(40, curvature)));
    fmt::print("curvature {}: slopes are off by {:.4f} with 14 elements across, {:.4f} with 40\n", curvature,
               coarse, fine);
    EXPECT_LT(coarse, 0.08);
    EXPECT_LT(fine, 14.0 / 40 * coarse);
  }
}

/// The stated errors of derivatives are those of the elements: the limit lies within them, and they shrink.
TEST(CreepCurves, ErrorsOfSlopesHold) {
  for (const double curvature : {2e-3, 1e-3})
    for (const int across : {20, 28, 40}) {
      const CreepCurves c = curves(hertz(across, curvature));
      for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Fs, phi}, {Mz, eta}, {Mz, phi}}) {
        const double true_error = std::abs(c.slopes.values[f][k] - c.linear->slopes[f][k]);
        // Kalker's table has four digits.
        EXPECT_LE(true_error, c.slopes.errors[f][k] + 2e-3 * std::abs(c.linear->slopes[f][k]))
            << curvature << " " << across << " " << f << k;
        EXPECT_LT(c.slopes.errors[f][k], 0.2 * std::abs(c.slopes.values[f][k]));
      }
    }
}

TEST(CreepCurves, TheEllipseIsHertzs) {
  const CreepCurves c = curves(hertz(20, 1e-3));
  ASSERT_TRUE(c.linear);
  // Circle: a^3 = 3 F / (8 E* A), E* = G / (1 - nu).
  const double a = std::cbrt(3 * 4000 / (8 * 82000 / 0.72 * 1e-3));
  EXPECT_NEAR(c.linear->semi_axis_x, a, 1e-6 * a);
  EXPECT_NEAR(c.linear->semi_axis_s, a, 1e-6 * a);
  EXPECT_NEAR(c.linear->coefficients.c11, 4.22, 0.05); // the no-slip limit for nu = 0.28
  EXPECT_NEAR(c.bound, 0.3 * 4000, 1e-3);
  const CreepCurves flat = curves(hertz(20, 2e-3));
  EXPECT_NEAR(flat.linear->tilt, 0, 1e-6);
  EXPECT_GT(flat.linear->semi_axis_x, flat.linear->semi_axis_s); // less curved along x
}

/// Small spin turns the forces as small lateral creepage turns the moment: C23 stands in both.
TEST(CreepCurves, SlopesAreSkewSymmetricInSpinAndLateralCreepage) {
  const CreepCurves c = curves(hertz(16));
  EXPECT_NEAR(c.slopes.values[Fs][phi] / -c.slopes.values[Mz][eta], 1, 0.06);
  for (const auto& [f, k] : {std::pair(Fx, eta), {Fx, phi}, {Fs, xi}, {Mz, xi}})
    EXPECT_NEAR(c.slopes.values[f][k] / c.slopes.values[f == Mz ? Mz : Fx][f == Mz ? eta : xi], 0, 1e-3);
}

/// Odd in the creepage, within the bound, and on it in full slip.
TEST(CreepCurves, CurvesAreOddAndEndAtTheFrictionBound) {
  const CreepCurves c =
      curves(hertz(16), {{CreepKind::xi, {}}, {CreepKind::eta, {-2e-2, -1e-4, 1e-4, 2e-2}}});
  EXPECT_TRUE(certified(c));
  const auto& x = c.curves[0].points;
  ASSERT_EQ(x.size(), 25u);
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(x[i].creepage, -x[x.size() - 1 - i].creepage, 1e-15);
    EXPECT_NEAR(x[i].forces[Fx], -x[x.size() - 1 - i].forces[Fx], 1e-5 * c.bound);
    EXPECT_LT(std::hypot(x[i].forces[Fx], x[i].forces[Fs]), c.bound * (1 + 1e-6));
    EXPECT_GT(x[i].forces[Fx], x[i > 0 ? i - 1 : 0].forces[Fx] - 1e-5 * c.bound);
  }
  EXPECT_EQ(x[12].creepage, 0);
  EXPECT_GT(x.back().forces[Fx], 0.97 * c.bound);
  const auto& lateral = c.curves[1].points;
  EXPECT_NEAR(lateral.back().forces[Fs], c.bound, 1e-3 * c.bound);
  EXPECT_EQ(lateral.back().adhesion_share, 0);
  EXPECT_NEAR(lateral[2].forces[Fs], 1e-4 * c.slopes.values[Fs][eta], 0.2 * lateral[2].forces[Fs]);
}

TEST(CreepCurves, APointIsWhatTheSceneGivesAlone) {
  const std::string motion = "xi = 4e-4\neta = 3e-4\nphi = 2e-4\n";
  const CreepCurves c = curves(hertz(16, 2e-3, motion), {{CreepKind::phi, {-1e-4, 2e-4, 6e-4}}});
  for (const CreepPoint& p : c.curves[0].points) {
    SceneFile alone = hertz(16, 2e-3, motion);
    alone.motion.phi = p.creepage;
    const MeasuredCreepForces expected = forces_of(Sequence().solve(alone));
    for (const std::size_t f : {Fx, Fs})
      EXPECT_NEAR(p.forces[f], expected[f], 2e-6 * c.bound);
    EXPECT_NEAR(p.forces[Mz], expected[Mz], 1e-5 * c.bound);
  }
}

/// Differences of the curve itself, with another step.
TEST(CreepCurves, SensitivitiesAreTheSlopesOfTheCurves) {
  const std::string motion = "xi = 4e-4\neta = 3e-4\nphi = 2e-4\n";
  const CreepCurves c = curves(hertz(24, 2e-3, motion), {{CreepKind::xi, {3.9e-4, 4.1e-4}},
                                                         {CreepKind::eta, {2.9e-4, 3.1e-4}},
                                                         {CreepKind::phi, {1.9e-4, 2.1e-4}}});
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& p = c.curves[k].points;
    for (const std::size_t f : {Fx, Fs, Mz}) {
      const double slope = (p[1].forces[f] - p[0].forces[f]) / (p[1].creepage - p[0].creepage);
      double scale = 0;
      for (const std::size_t other : {Fx, Fs})
        scale = std::max(scale, std::abs(c.sensitivities.values[other][k]));
      EXPECT_NEAR(c.sensitivities.values[f][k], slope, 0.03 * scale) << f << " " << k;
    }
  }
  EXPECT_LT(c.sensitivities.values[Fx][xi], c.slopes.values[Fx][xi]); // saturation
  EXPECT_LT(c.sensitivities.values[Fs][xi], 0); // a larger xi turns the slip away from s
}

/// The compliance of a layer's slope is found once and held: all points are those of a layer that is given.
/// Points that others solve are the same.
TEST(CreepCurves, TheLayerOfASlopeIsFoundOnce) {
  const SceneFile asked =
      parse_scene_file("kind = \"patch\"\nlayer.slope = 0.5\n[load]\nforce = 4000\n[motion]\nfriction = "
                       "0.3\nxi = 1e-3\n[grid]\n"
                       "dx = 0.4\nds = 0.4\nmx = 20\nms = 14\n[gap]\na = 1e-3\nb = 2e-3\n");
  const std::vector<CreepRange> ranges{{CreepKind::xi, {0, 5e-4, 1e-3}}};
  std::vector<HeldContact> held;
  const CreepCurves c = creep_curves(asked, ranges, nullptr,
                                     [&](const HeldContact& contact, std::span<const Creepages> points) {
                                       held.push_back(contact);
                                       EXPECT_EQ(points.size(), 3u); // derivatives are solved here
                                       return creep_points(asked, contact, points);
                                     });
  ASSERT_EQ(held.size(), 1u);
  ASSERT_TRUE(held.front().layer_compliance);
  EXPECT_EQ(*held.front().layer_compliance, c.solution.layer.shear.front());
  SceneFile given = asked;
  given.layer.slope.reset();
  given.layer.compliance = held.front().layer_compliance;
  for (const CreepCurves& other : {curves(given, ranges), curves(asked, ranges)})
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(c.curves.front().points[i].forces[Fx], other.curves.front().points[i].forces[Fx], 1e-3);
}

/// With nothing slipping, they are the slopes; in full slip along x, dFs/deta = mu Fn / xi and dFx/dxi = 0.
TEST(CreepCurves, SensitivitiesAreExactAtBothEnds) {
  const CreepCurves rest = curves(hertz(20, 2e-3, "xi = 1e-9\n"));
  for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Fs, phi}, {Mz, eta}, {Mz, phi}})
    EXPECT_NEAR(rest.sensitivities.values[f][k] / rest.slopes.values[f][k], 1, 2e-3);
  const CreepCurves slip = curves(hertz(20, 2e-3, "xi = 0.5\n"));
  EXPECT_NEAR(slip.sensitivities.values[Fs][eta] / (slip.bound / 0.5), 1, 1e-2);
  EXPECT_NEAR(slip.sensitivities.values[Fx][xi], 0, 1e-3 * slip.bound / 0.5);
}

/// Yaw and spin of the geometry are found from the rigid slip and cancelled: the slopes are those at rest.
TEST(CreepCurves, SlopesOfAWheelOnARailDoNotDependOnItsCreepages) {
  const auto wheel = [](const std::string& more) {
    return parse_scene_file(
        "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 5e4\n"
        "solver.model = \"halfspace\"\ngrid.dx = 0.7\ngrid.ds = 0.7\nposition.rail_inclination = 0.025\n" +
        more);
  };
  const CreepCurves
      a = curves(wheel("position.lateral = -3\n"), {}),
      b = curves(wheel("position.lateral = -3\nmotion.xi = 1e-3\nmotion.eta = -1e-3\nmotion.phi = 1e-4\n"),
                 {});
  for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Mz, phi}})
    EXPECT_NEAR(b.slopes.values[f][k] / a.slopes.values[f][k], 1, 0.03);
  ASSERT_TRUE(a.linear);
  fmt::print("S1002 on 60E1 at -3 mm: slopes are off Kalker's by {:.3f}, the distance is off a quadratic by "
             "{:.3f}\n",
             off(a), a.linear->deviation);
  EXPECT_LT(off(a), 0.25);
}

constexpr const char* a_flange =
    "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 87130.3586888962\n"
    "solver.model = \"halfspace\"\nmotion.free_rolling = false\nmotion.friction = 0.4\n"
    "[position]\nrail_inclination = 0.025\nlateral = 6.604187943447943\nyaw = 0.003\n";
constexpr const char* a_tread =
    "rail.profile = \"60E1\"\nwheel.profile = \"S1002\"\nload.force = 8e4\nmotion.free_rolling = false\n"
    "solver.model = \"halfspace\"\nposition.rail_inclination = 0.025\nposition.lateral = -2.5\n";

/// Grids differ by a row from point to point at a flange root. The stated errors of slopes are useful, and
/// cover what elements of half the size change.
TEST(CreepCurves, ErrorsOfSlopesCoverSmallerElements) {
  for (const char* scene : {a_flange, a_tread}) {
    const CreepCurves c = curves(parse_scene_file(scene), {});
    SceneFile smaller = parse_scene_file(scene);
    const ContactGrid& grid = c.solution.problem.grid;
    smaller = with_elements(smaller, 0.5 * grid.dx, 0.5 * grid.ds);
    const CreepCurves fine = curves(smaller, {});
    for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Fs, phi}, {Mz, eta}, {Mz, phi}}) {
      const double stated = c.slopes.errors[f][k], value = c.slopes.values[f][k];
      fmt::print("{}{}: {:.5g} +- {:.2g}, on smaller elements {:.5g} +- {:.2g}\n", f, k, value, stated,
                 fine.slopes.values[f][k], fine.slopes.errors[f][k]);
      EXPECT_LE(std::abs(fine.slopes.values[f][k] - value), stated) << f << k;
      EXPECT_LT(stated, 0.15 * std::abs(value)) << f << k;
    }
  }
}

/// Derivatives of solutions and differences of others agree within what they state, and the former take a
/// tenth of the solutions. Closed forms have no derivatives.
TEST(CreepCurves, DerivativesAreThoseOfDifferences) {
  for (const char* scene : {a_flange, a_tread}) {
    SceneFile asked = parse_scene_file(scene);
    asked.motion.xi = 5e-4;
    asked.motion.eta = 3e-4;
    const CreepCurves c = curves(asked);
    EXPECT_FALSE(c.sensitivities.by_differences);
    EXPECT_FALSE(c.slopes.by_differences);
    EXPECT_EQ(c.contact_problems, 1 + 2 + 2);
    SceneFile counted = asked; // elements of a wheel that are counted have no larger ones
    const ContactGrid& grid = c.solution.problem.grid;
    counted = with_elements(counted, grid.dx, grid.ds);
    counted.grid.mx = grid.mx;
    counted.grid.ms = grid.ms;
    const CreepCurves d = curves(counted);
    EXPECT_TRUE(d.sensitivities.by_differences);
    EXPECT_EQ(d.contact_problems, 1 + 12 + 12);
    for (const auto& [f, k] : {std::pair(Fx, xi), {Fs, eta}, {Fs, phi}, {Mz, eta}, {Mz, phi}})
      for (const auto& [one, other] :
           {std::pair(&c.sensitivities, &d.sensitivities), {&c.slopes, &d.slopes}}) {
        fmt::print("{}{}: {:.5g} +- {:.2g}, by differences {:.5g} +- {:.2g}\n", f, k, one->values[f][k],
                   one->errors[f][k], other->values[f][k], other->errors[f][k]);
        EXPECT_LE(std::abs(one->values[f][k] - other->values[f][k]), one->errors[f][k]) << f << k;
      }
  }
  SceneFile closed = parse_scene_file(a_tread);
  closed.solver.model = Model::simplified;
  EXPECT_TRUE(curves(closed).slopes.by_differences);
}

TEST(CreepCurves, RefusesScenesWithoutCreepages) {
  const auto refused = [](const std::string& more, const char* word, std::vector<CreepRange> ranges = {}) {
    try {
      curves(hertz(8, 2e-3, more), ranges);
      ADD_FAILURE() << more;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(word));
    }
  };
  refused("frictionless = true\n", "no friction");
  refused("kind = \"shift\"\n", "no steady rolling");

  refused("", "not a number", {{CreepKind::xi, {NAN}}});
  refused("", "10000 are allowed", {{CreepKind::xi, std::vector<double>(10001, 0.0)}});
}

} // namespace
