#include "bem_contact/base/error.hpp"
#include "fem_influence/harmonic/stresses_inside.hpp"
#include "section_meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bem_contact::fem::test {
namespace {

BodyFile block_body() {
  BodyFile body;
  body.body.kind = BodyKind::block;
  body.strip = {-6, 6, 0.5};
  body.harmonic.half_period = 200;
  return body;
}

StressesInside below_ellipse(const EllipticalLoad& load) {
  const Folder folder;
  write_block_mesh(folder / "block.msh", 0.5, 6, 150);
  return stresses_inside(block_body(), straight_line(150), folder / "block.msh", load,
                         [](std::size_t, std::size_t) {});
}

double largest(const StressesInside& inside, std::vector<halfspace::Stress> StressesAtPoint::*which) {
  double out = 0;
  for (const StressesAtPoint& p : inside.points)
    for (const halfspace::Stress& t : p.*which)
      out = std::max(out, von_mises(t));
  return out;
}

/// A large flat block has the stresses of the half-space's closed forms, with and without friction: each
/// component within 1.2 % of the largest von Mises stress (1.08 % seen), which itself is right within 0.5 %.
/// What is left is the bending of the block on its support.
TEST(StressesInside, OfAFlatBlockAreTheHalfSpaces) {
  for (const double friction : {0.0, 0.3}) {
    const StressesInside inside =
        below_ellipse({.s = 0, .a = 5, .b = 4, .pressure = 1000, .friction = friction});
    ASSERT_GT(inside.points.size(), 200U);
    const double scale = largest(inside, &StressesAtPoint::flat);
    EXPECT_NEAR(largest(inside, &StressesAtPoint::body), scale, 0.005 * scale);
    double worst = 0;
    for (const StressesAtPoint& p : inside.points)
      for (std::size_t j = 0; j < inside.x.size(); ++j) {
        const halfspace::Stress &a = p.body[j], &b = p.flat[j];
        for (const double difference :
             {a.xx - b.xx, a.ss - b.ss, a.nn - b.nn, a.xs - b.xs, a.xn - b.xn, a.sn - b.sn})
          worst = std::max(worst, std::abs(difference));
      }
    EXPECT_LT(worst, 0.012 * scale) << friction;
  }
}

/// Hertz on a circle: 0.3146 p0 is the largest shear on the axis, 0.47 a deep (nu = 0.28).
TEST(StressesInside, OfAHertzCircle) {
  const StressesInside inside = below_ellipse({.s = 0, .a = 4, .b = 4, .pressure = 1000});
  double shear = 0, depth = 0;
  for (const StressesAtPoint& p : inside.points)
    for (const halfspace::Stress& t : p.body)
      if (largest_shear(t) > shear) {
        shear = largest_shear(t);
        depth = p.depth;
      }
  EXPECT_NEAR(shear, 314.6, 0.01 * 314.6);
  EXPECT_NEAR(depth, 0.47 * 4, 0.3);
}

TEST(StressesInside, RefusesALoadBesideTheStrip) {
  EXPECT_THROW(below_ellipse({.s = 4, .a = 3, .b = 3, .pressure = 1}), InputError);
}

} // namespace
} // namespace bem_contact::fem::test
