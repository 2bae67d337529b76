#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/body_stresses.hpp"
#include "fem_influence/harmonic/remainder.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bem_contact::fem::test {
namespace {

using halfspace::Stress;
using inside::AreaStresses;
using inside::BelowSurface;
using inside::StressesInside;
using inside::SurfaceTractions;

void without_progress(std::size_t, std::size_t) {}

BodyFile block_body() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.strip = {-6, 6, 0.5};
  body.harmonic.half_period = 200;
  return body;
}

StressesInside inside_block(const SurfaceTractions& load, std::span<const BelowSurface> own = {}) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 6, 150);
  StressesInside out = inside::halfspace_inside(load, inside::Side::rail, own);
  add_body_stresses(out, load, block_body(), straight_line(150), folder / "block.msh", without_progress);
  return out;
}

std::array<double, 6> components(const Stress& t) {
  return {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn};
}

/// Largest difference of a component, MPa.
double largest_difference(const Stress& a, const Stress& b) {
  double out = 0;
  for (const double d : components(difference(a, b)))
    out = std::max(out, std::abs(d));
  return out;
}

/// From the surface on, a large flat block has the stresses of the half-space's closed forms within 0.5 % of
/// the largest von Mises stress, with and without friction. The stated error covers that.
TEST(StressesInside, OfAFlatBlockAreTheHalfSpaces) {
  for (const double friction : {0.0, 0.3}) {
    const StressesInside found =
        inside_block(tractions_of({.s = 0, .a = 5, .b = 4, .pressure = 1000, .friction = friction}, 0.28));
    const AreaStresses& area = found.areas.at(0);
    const double scale = peaks_of(found, area).flat_von_mises.value;
    EXPECT_NEAR(peaks_of(found, area).von_mises.value, scale, 0.002 * scale);
    double worst = 0;
    for (std::size_t i = 0; i < area.points.size(); ++i) {
      double here = 0;
      for (std::size_t j = 0; j < area.x.size(); ++j)
        here = std::max(here, largest_difference(area.body[i][j], area.flat[i][j]));
      worst = std::max(worst, here);
      EXPECT_LE(here, area.error[i] + 0.004 * scale);
    }
    EXPECT_LT(worst, 0.005 * scale) << friction;
  }
}

/// The unit traction of one element, along each axis, from a tenth of its width on: within 0.5 % of the
/// traction.
TEST(StressesInside, OfOneElementAreTheHalfSpaces) {
  std::vector<BelowSurface> points;
  for (const double depth : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
    points.push_back({0.25, depth});
  for (const int component : {int(component_x), int(component_s), int(component_n)}) {
    SurfaceTractions one{
        .dx = 0.5, .ds = 0.5, .x0 = 0, .columns = 1, .s = {0.25}, .px = {0}, .ps = {0}, .pn = {1e-9}};
    (component == component_x ? one.px : component == component_s ? one.ps : one.pn) = {1};
    const StressesInside found = inside_block(one, points);
    const AreaStresses& area = found.areas.at(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      double worst = 0;
      for (std::size_t j = 0; j < area.x.size(); ++j)
        worst = std::max(worst, largest_difference(area.body[i][j], area.flat[i][j]));
      EXPECT_LT(worst, 0.005) << component << " depth " << points[i].depth;
    }
  }
}

/// Hertz on a circle: 0.3146 p0 is the largest shear on the axis, 0.47 a deep (nu = 0.28).
TEST(StressesInside, OfAHertzCircle) {
  const StressesInside found = inside_block(tractions_of({.s = 0, .a = 4, .b = 4, .pressure = 1000}, 0.28));
  const inside::Peak shear = peaks_of(found, found.areas.at(0)).shear;
  EXPECT_NEAR(shear.value, 314.6, 0.01 * 314.6);
  EXPECT_NEAR(shear.at.depth, 0.47 * 4, 0.3);
}

/// What a body has more than the half-space is carried to the surface as a parabola, and no traction is
/// there.
TEST(Remainder, IsNoTractionOfTheSurface) {
  const auto at = [](double d) { // along: 3 + 2 d + d2; across: 5 d + d2
    const double along = 3 + 2 * d + d * d, across = 5 * d + d * d;
    return inside::Passage{{along, -along, across, 2 * along, -across, 3 * across}};
  };
  const std::vector<inside::Passage> helpers{at(helper_depths[0]), at(helper_depths[1]),
                                             at(helper_depths[2])};
  for (const double d : {0.0, 0.3, 0.9}) {
    const Remainder found = towards_surface(helpers, d, 0);
    EXPECT_NEAR(largest_difference(found.stresses.at(0), at(d).at(0)), 0, 1e-12) << d;
    EXPECT_GT(found.error, 0);
  }
  const Stress surface = towards_surface(helpers, 0, 0).stresses.at(0);
  EXPECT_EQ(surface.nn, 0);
  EXPECT_EQ(surface.xn, 0);
  EXPECT_EQ(surface.sn, 0);
}

TEST(StressesInside, RefusesALoadBesideTheStrip) {
  EXPECT_THROW(inside_block(tractions_of({.s = 4, .a = 3, .b = 3, .pressure = 1}, 0.28)), InputError);
}

/// Points that lie beside the body have no stresses there, and those of the half-space all the same.
TEST(StressesInside, KnowWhereTheBodyEnds) {
  const std::vector<BelowSurface> points{{0, 2}, {0, 151}};
  const StressesInside found =
      inside_block(tractions_of({.s = 0, .a = 3, .b = 3, .pressure = 1}, 0.28), points);
  EXPECT_TRUE(std::isfinite(found.areas.at(0).body[0][0].xx));
  EXPECT_FALSE(std::isfinite(found.areas.at(0).body[1][0].xx));
  EXPECT_TRUE(std::isfinite(found.areas.at(0).flat[1][0].xx));
}

} // namespace
} // namespace bem_contact::fem::test
