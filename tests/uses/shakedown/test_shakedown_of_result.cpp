#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"
#include "tests/base/message.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;
using ::testing::HasSubstr;

/// Hertz: 1/E* = (1 - nu) / G, R = 50 mm, a^3 = 3 F R / (4 E*), p0 = 3 F / (2 pi a^2).
constexpr double hertz_p0 = 1001.33, hertz_a = 0.69053; // MPa, mm

/// A Hertz circle in full slip; nu = 0.28.
SceneResult circle(double mu, int elements = 36, const std::string& motion = "xi = 0.05\n") {
  const double side = 1.6 / elements;
  const std::string both = "shear_modulus = 82000\npoisson = 0.28\n";
  return Sequence().solve(parse_scene_file(
      "kind = \"patch\"\nsolver.model = \"halfspace\"\n[rail.material]\n" + both + "[wheel.material]\n" +
      both + "[motion]\n" +
      (mu > 0 ? "friction = " + std::to_string(mu) + "\n" + motion : "frictionless = true\n") +
      "[load]\nforce = 1000\n[grid]\ndx = " + std::to_string(side) + "\nds = " + std::to_string(side) +
      "\nmx = " + std::to_string(elements) + "\nms = " + std::to_string(elements) +
      "\n[gap]\na = 0.01\nb = 0.01\n"));
}

PatchShakedown patch_of(const SceneResult& result, Residual residual, double k = 300) {
  const Shakedown found = shakedown_of(result, {.yield_shear = k, .residual = residual});
  EXPECT_EQ(found.patches.size(), 1U);
  return found.patches.at(0);
}

/// Below the row next to the middle, at least 0.4 a deep.
double dang_van_in_the_middle(const PatchShakedown& p) {
  double out = 0, nearest = 1e9;
  for (const double s : p.section.s)
    nearest = std::min(nearest, std::abs(s));
  for (std::size_t is = 0; is < p.section.s.size(); ++is)
    for (std::size_t id = 0; id < p.section.depths.size(); ++id)
      if (std::abs(p.section.s[is]) <= nearest && p.section.depths[id] > 0.4 * p.section.size)
        out = std::max(out, p.maps.dang_van[p.section.point(is, id)]);
  return out;
}

struct CircleLimit {
  double mu, shakedown, dang_van;
};
constexpr CircleLimit circle_limits[] = {
    {0, 4.683, 0.1587}, {0.1, 4.145, 0.1621}, {0.2, 3.694, 0.1666}, {0.3, 3.328, 0.1733}};

/// p0/k after Melan and Dang Van's stress with a = 0.4 of a circle that slips all over, found by another
/// program in the plane y = 0 with residual stresses xx and ss alone. Here it is the whole block with all
/// fields of the plane. 4.683 is the textbooks' value.
TEST(ShakedownOfResult, CircleThatSlipsAllOver) {
  for (const CircleLimit& right : circle_limits) {
    const PatchShakedown p = patch_of(circle(right.mu, 30), Residual::in_plane);
    EXPECT_NEAR(p.lower.value * hertz_p0 / 300, right.shakedown, 0.01 * right.shakedown) << right.mu;
    EXPECT_LE(p.lower.value, p.upper.value);
    EXPECT_NEAR(p.upper.value, p.lower.value, 0.01 * p.lower.value) << right.mu;
    EXPECT_NEAR(dang_van_in_the_middle(p), right.dang_van * hertz_p0, 0.01 * right.dang_van * hertz_p0)
        << right.mu;
    EXPECT_GE(p.dang_van.value, dang_van_in_the_middle(p));
  }
}

/// First yield p0/k without friction, and the largest shear on the axis: 0.3146 p0 at 0.47 a, where von
/// Mises' stress is twice as large.
TEST(ShakedownOfResult, FirstYieldOfACircle) {
  const PatchShakedown p = patch_of(circle(0), Residual::all);
  EXPECT_NEAR(p.first_yield.value * hertz_p0 / 300, 2.755, 0.01 * 2.755);
  EXPECT_NEAR(p.first_yield.depth, 0.47 * hertz_a, 0.06 * hertz_a);
  EXPECT_NEAR(p.first_yield.s, 0, 0.06 * hertz_a);
  EXPECT_NEAR(patch_of(circle(0.3), Residual::all).first_yield.value * hertz_p0 / 300, 2.594, 0.01 * 2.594);
}

/// Where residual shear along the track may build up, too, a patch bears more friction: up to what its
/// surface bears, which no residual shear reaches. Without friction nothing changes.
TEST(ShakedownOfResult, ShearAlongTheTrack) {
  for (const double mu : {0.0, 0.1, 0.3}) {
    const SceneResult result = circle(mu, 28);
    const PatchShakedown plane = patch_of(result, Residual::in_plane), all = patch_of(result, Residual::all);
    EXPECT_GE(all.lower.value, 0.999 * plane.lower.value);
    if (mu == 0.1)
      EXPECT_GT(all.lower.value, 1.08 * plane.lower.value);
    else
      EXPECT_LT(all.lower.value, 1.01 * plane.lower.value);
    if (mu == 0.3) {
      EXPECT_EQ(all.lower.depth, 0);
      EXPECT_LT(all.lower.value * all.pmax / 300, 1.02 / 0.3);
    }
  }
}

/// Below the first yield never, up to the shakedown limit once, above it for ever.
TEST(ShakedownOfResult, YieldingGoesByTheLoad) {
  const SceneResult result = circle(0.1, 28);
  const PatchShakedown p = patch_of(result, Residual::all);
  EXPECT_EQ(p.yielding, p.first_yield.value < 1 ? Yielding::once : Yielding::never);
  const auto at_factor = [&](double limit, double factor) {
    return patch_of(result, Residual::all, 300 * factor / limit).yielding;
  };
  EXPECT_EQ(at_factor(p.first_yield.value, 1.01), Yielding::never);
  EXPECT_EQ(at_factor(p.first_yield.value, 0.99), Yielding::once);
  EXPECT_EQ(at_factor(p.lower.value, 1.01), Yielding::once);
  EXPECT_EQ(at_factor(p.upper.value, 0.99), Yielding::for_ever);
  EXPECT_THAT(in_words(patch_of(result, Residual::all, 300 * 0.95 / p.upper.value), {.yield_shear = 200}),
              HasSubstr("yields for ever (shakedown factor 0.9"));
}

/// Factors go as k; Dang Van's stress does not know it.
TEST(ShakedownOfResult, ScalesWithTheSteel) {
  const SceneResult result = circle(0.2, 24);
  const PatchShakedown soft = patch_of(result, Residual::all, 200),
                       hard = patch_of(result, Residual::all, 500);
  EXPECT_NEAR(hard.lower.value, 2.5 * soft.lower.value, 1e-3 * hard.lower.value);
  EXPECT_NEAR(hard.upper.value, 2.5 * soft.upper.value, 1e-4 * hard.upper.value);
  EXPECT_DOUBLE_EQ(hard.dang_van.value, soft.dang_van.value);
}

/// Rolling backwards, or with the shear to the other side, is the same.
TEST(ShakedownOfResult, IsTheSameMirrored) {
  const PatchShakedown ahead = patch_of(circle(0.2, 24), Residual::all),
                       back = patch_of(circle(0.2, 24, "xi = -0.05\n"), Residual::all),
                       right = patch_of(circle(0.2, 24, "eta = 0.05\n"), Residual::all),
                       left = patch_of(circle(0.2, 24, "eta = -0.05\n"), Residual::all);
  EXPECT_NEAR(back.lower.value, ahead.lower.value, 1e-3 * ahead.lower.value);
  EXPECT_NEAR(back.dang_van.value, ahead.dang_van.value, 3e-3 * ahead.dang_van.value);
  EXPECT_NEAR(left.lower.value, right.lower.value, 1e-3 * right.lower.value);
  EXPECT_NEAR(left.lower.s, -right.lower.s, 1e-6);
}

/// From stresses as a file has them: the same without a body. With one, its stresses count: twice as large,
/// half the factors. Where the body ends the block ends, and what is left bears no more.
TEST(ShakedownOfResult, OfStressesOfABody) {
  const SceneResult result = circle(0.1, 24);
  const PatchShakedown alone = patch_of(result, Residual::all);
  inside::SurfaceTractions t{.dx = result.problem.grid.dx,
                             .ds = result.problem.grid.ds,
                             .x0 = result.problem.grid.x0,
                             .columns = result.problem.grid.mx,
                             .s = {},
                             .px = result.result.px,
                             .ps = result.result.ps,
                             .pn = result.result.pn,
                             .poisson = 0.28};
  for (const ContactRow& row : result.problem.rows)
    t.s.push_back(row.s);
  inside::StressesInside stresses = inside::halfspace_inside(t, inside::Side::rail);
  EXPECT_DOUBLE_EQ(shakedown_of(stresses).patches.at(0).lower.value, alone.lower.value);
  inside::AreaStresses& area = stresses.areas.at(0);
  area.body = area.flat;
  for (inside::Passage& passage : area.body)
    for (halfspace::Stress& s : passage)
      s.add(1, s);
  EXPECT_NEAR(shakedown_of(stresses).patches.at(0).lower.value, alone.lower.value / 2,
              1e-3 * alone.lower.value);
  area.body = area.flat;
  for (std::size_t i = 0; i < area.body.size(); ++i)
    if (area.points[i].depth > 1.5 * area.section->size)
      for (halfspace::Stress& s : area.body[i])
        s.xx = std::nan("");
  const PatchShakedown thin = shakedown_of(stresses).patches.at(0);
  EXPECT_LE(thin.lower.value, alone.lower.value * (1 + 1e-3));
  EXPECT_GE(thin.lower.value, thin.first_yield.value * (1 - 1e-3));
  EXPECT_LE(thin.section.depths.back(), 1.5 * area.section->size);
  stresses.areas[0].section.reset();
  EXPECT_THAT(message_of([&] { shakedown_of(stresses); }), HasSubstr("points of one's own"));
}

TEST(ShakedownOfResult, RefusesWhatItCannotAnswer) {
  const SceneResult result = circle(0, 24);
  EXPECT_THAT(message_of([&] { shakedown_of(result, {.yield_shear = 0}); }),
              HasSubstr("The yield stress in shear cannot be 0"));
  EXPECT_THAT(message_of([&] { shakedown_of(result, {.dang_van_a = std::nan("")}); }),
              HasSubstr("Dang Van's a"));
  SceneResult wrong;
  wrong.result.trust.certificate.penetration = 1;
  EXPECT_THAT(fault_of([&] { shakedown_of(wrong); }), HasSubstr("is not a solution"));
  SceneResult coarse = circle(0, 4);
  EXPECT_EQ(shakedown_of(coarse).patches.size() + shakedown_of(coarse).too_small, 1U);
}

} // namespace
