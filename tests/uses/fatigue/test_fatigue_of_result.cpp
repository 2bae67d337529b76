#include "bem_contact/base/error.hpp"
#include "bem_contact/contact/grid/patches.hpp"
#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "tests/uses/fatigue/hertz_patch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace bem_contact;
using namespace bem_contact::fatigue;
using ::testing::HasSubstr;

/// One square element of side 1 under p_n = 1, nu = 0.28. Of depths in steps of a tenth, 0.4 has the largest
/// stress. Between them it is 0.6717 at 0.35: Boussinesq's point load summed over 400 x 400 points says so
/// too.
TEST(Stresses, BelowAUnitSquare) {
  const auto mises = [](double px, double z) {
    const auto unit = halfspace::rectangle_stress(0.28, 0, 0, z, 0.5, 0.5);
    halfspace::Stress sum;
    sum.add(1, unit[2]).add(px, unit[0]);
    return von_mises(sum);
  };
  EXPECT_NEAR(mises(0, 0.4), 0.665, 5e-4);
  EXPECT_LT(mises(0, 0.3), mises(0, 0.4));
  EXPECT_LT(mises(0, 0.5), mises(0, 0.4));
  EXPECT_NEAR(mises(0, 0.35), 0.67166, 1e-5);
  const double depths[] = {1e-9, 0.1, 0.2, 0.5, 1}, expected[] = {1.744, 1.349, 1.067, 0.676, 0.343};
  for (int i = 0; i < 5; ++i)
    EXPECT_NEAR(mises(0.999, depths[i]), expected[i], 5.1e-4) << depths[i];
}

SceneResult solved(const std::string& motion, const std::string& more = "") {
  return Sequence().solve(parse_scene_file(
      "kind = \"patch\"\nsolver.model = \"halfspace\"\n[rail.material]\nshear_modulus = "
      "80769.230769\npoisson = "
      "0.3\n[wheel.material]\nshear_modulus = 80769.230769\npoisson = 0.3\n[motion]\n" +
      motion +
      (more.empty() ? "[load]\nforce = 1000\n[grid]\ndx = 0.05\nds = 0.05\nmx = 32\nms = 32\n[gap]\na = "
                      "0.01\nb = 0.01\n"
                    : more)));
}

/// Sphere R 50, F 1000: tau_max = 0.310 p0 at 0.48 a below the middle (Johnson 1985, section 4.2). On the
/// axis of symmetry von Mises' stress is twice the largest shear.
TEST(StressPeaks, HertzOnACircle) {
  const Fatigue f = fatigue_of(solved("frictionless = true\n"));
  ASSERT_TRUE(f.peaks);
  const double p0 = 1010.07, a = 0.68753;
  EXPECT_NEAR(f.peaks->tresca.stress, 0.310 * p0, 0.01 * 0.310 * p0);
  EXPECT_NEAR(f.peaks->tresca.depth, 0.48 * a, 0.02 * a);
  EXPECT_NEAR(f.peaks->von_mises.stress, 0.620 * p0, 0.01 * 0.620 * p0);
  EXPECT_NEAR(f.peaks->von_mises.depth, 0.48 * a, 0.02 * a);
  EXPECT_NEAR(std::hypot(f.peaks->von_mises.x, f.peaks->von_mises.s), 0, 0.03);
}

/// Full slip draws the peak towards the surface.
TEST(StressPeaks, RiseTowardsTheSurfaceWithFriction) {
  const StressPeaks rolling = *fatigue_of(solved("friction = 0.3\nxi = 0.05\n")).peaks,
                    still = *fatigue_of(solved("frictionless = true\n")).peaks;
  EXPECT_LT(rolling.von_mises.depth, 0.9 * still.von_mises.depth);
  EXPECT_GT(rolling.von_mises.stress, still.von_mises.stress);
}

/// In full slip each number follows from Hertz: mu used is mu, p0 is Hertz', T-gamma is mu F xi.
TEST(FatigueOfResult, FullSlipOnACircle) {
  const double xi = 0.05, force = 1000, mu = 0.3, k = 300;
  const Fatigue f = fatigue_of(solved("friction = 0.3\nxi = 0.05\n"), {.yield_shear = k, .stresses = false});
  ASSERT_EQ(f.patches.size(), 1U);
  const PatchFatigue& patch = f.patches[0];
  const ShakedownPoint hertz = shakedown_point({0.68753443, 0.68753443, force, mu * force}, k);
  EXPECT_NEAR(patch.normal_force, force, 1e-5 * force);
  EXPECT_NEAR(patch.point.traction, mu, 1e-5);
  EXPECT_NEAR(patch.point.load, hertz.load, 0.01 * hertz.load);
  EXPECT_NEAR(patch.surface_index, surface_index(hertz), 0.01);
  EXPECT_NEAR(patch.t_gamma, mu * force * xi, 0.01 * mu * force * xi);
  EXPECT_EQ(patch.damage, 0); // 15 N
  EXPECT_NEAR(patch.largest_index, mu - k / patch.pmax, 1e-6);
  EXPECT_FALSE(f.peaks);
}

/// Two patches on one grid are told apart, the one with the larger force first.
TEST(FatigueOfResult, EachPatchOnItsOwn) {
  SceneResult r;
  r.result.trust.certificate = Certificate::without_violation();
  r.problem.grid = {3, 5, 1.0, 2.0, -1};
  for (int i = 0; i < 5; ++i)
    r.problem.rows.push_back({2.0 * i, {2.0 * i, 0.0}, 0.0});
  r.problem.numbers.dx = 1;
  for (auto* field : {&r.result.px, &r.result.ps, &r.result.pn, &r.result.slip_x, &r.result.slip_s})
    field->assign(15, 0.0);
  r.result.pn[0] = 500;
  r.result.pn[4] = 300; // a neighbour across the corner
  r.result.pn[13] = 900;
  r.result.px[13] = 270;
  r.result.slip_x[13] = 0.1;
  r.problem.gap.assign(15, 0.0);
  for (const double p : r.result.pn)
    r.result.state.push_back(p > 0 ? ElementState::slip : ElementState::exterior);
  r.result.patches = contact::find_patches(r.problem, r.result);
  const Fatigue f = fatigue_of(r, {.stresses = false});
  ASSERT_EQ(f.patches.size(), 2U);
  EXPECT_DOUBLE_EQ(f.patches[0].normal_force, 1800);
  EXPECT_DOUBLE_EQ(f.patches[0].s, 8);
  EXPECT_DOUBLE_EQ(f.patches[0].point.traction, 0.3);
  EXPECT_DOUBLE_EQ(f.patches[0].t_gamma, 54);
  EXPECT_NEAR(f.patches[0].damage, (54.0 - 20) / 45 * 1e-5, 1e-15);
  EXPECT_DOUBLE_EQ(f.patches[1].normal_force, 1600);
  EXPECT_DOUBLE_EQ(f.patches[1].pmax, 500);
  EXPECT_DOUBLE_EQ(f.patches[0].largest_index, (270.0 - 300) / 900);
  EXPECT_EQ(f.patches[1].largest_index, -0.5);
  EXPECT_EQ(f.element_index[1], -0.5);
}

TEST(FatigueOfResult, RefusesWhatIsNoSolution) {
  SceneResult r;
  r.result.trust.certificate.penetration = 1;
  try {
    fatigue_of(r);
    FAIL();
  } catch (const ConvergenceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is not a solution"));
  }
}

} // namespace
