#include "bem_contact/base/error.hpp"
#include "bem_contact/reference/hertz.hpp"
#include "tests/base/message.hpp"
#include "tests/reference/line_and_quartic.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

using namespace bem_contact;
using namespace bem_contact::reference;

namespace {
Material from_young(double young, double poisson) {
  return {young / (2 * (1 + poisson)), poisson};
}
const double modulus = contact_modulus(from_young(210000, 0.3), from_young(210000, 0.3));
} // namespace

TEST(Hertz, PublishedVectors) {
  const HertzContact one = hertz_by_force(1.0 / 920, 1.0 / 600, modulus, 1e5);
  EXPECT_NEAR(one.semi_axis_x, 7.161676, 5e-7);
  EXPECT_NEAR(one.semi_axis_s, 5.387172, 5e-7);
  EXPECT_NEAR(one.max_pressure, 1237.5588, 5e-5);
  EXPECT_NEAR(one.approach, 0.10411895, 5e-9);
  const HertzContact two = hertz_by_force(1.0 / 920, 1.0 / 160, modulus, 82500);
  EXPECT_NEAR(two.semi_axis_x, 8.011383, 5e-7);
  EXPECT_NEAR(two.semi_axis_s, 2.533052, 5e-7);
  EXPECT_NEAR(two.max_pressure, 1941.0811, 5e-5);
  EXPECT_NEAR(two.approach, 0.10986554, 5e-9);
  const HertzContact sphere = hertz_by_force(0.01, 0.01, modulus, 1000);
  EXPECT_NEAR(sphere.semi_axis_x, 0.68753443, 5e-9);
  EXPECT_NEAR(sphere.semi_axis_s, sphere.semi_axis_x, 1e-14);
  EXPECT_NEAR(sphere.max_pressure, 1010.07234, 5e-6);
  EXPECT_NEAR(sphere.approach, 0.0094540719, 5e-11);
  const Material rail{82000, 0.28};
  const HertzContact four = hertz_by_approach(7.6859e-4, 9.8039e-4, contact_modulus(rail, rail), 0.09089);
  EXPECT_NEAR(four.force, 99986.51, 5e-3);
  EXPECT_NEAR(four.semi_axis_x, 7.843619, 5e-7);
  EXPECT_NEAR(four.semi_axis_s, 6.669087, 5e-7);
  EXPECT_NEAR(four.max_pressure, 912.6409, 5e-5);
}

TEST(Hertz, SphereHasItsOwnClosedForm) { // a^3 = 3FR/(4E*), delta = a^2/R (Johnson 1985, eqs 4.22, 4.23)
  const HertzContact c = hertz_by_force(0.01, 0.01, modulus, 1000);
  EXPECT_NEAR(c.semi_axis_x, std::cbrt(0.75 * 1000 * 50 / modulus), 1e-14);
  EXPECT_NEAR(c.approach, c.semi_axis_x * c.semi_axis_x / 50, 1e-16);
}

TEST(Hertz, ForceAndApproachAreInverse) {
  for (const double ratio : {1.0, 1.0 + 1e-9, 1.3, 20.0, 1e4}) {
    const HertzContact a = hertz_by_force(1e-3, ratio * 1e-3, modulus, 5e4);
    const HertzContact b = hertz_by_approach(1e-3, ratio * 1e-3, modulus, a.approach);
    EXPECT_NEAR(b.force / a.force, 1, 1e-13);
    EXPECT_NEAR(b.semi_axis_x / a.semi_axis_x, 1, 1e-13);
    const HertzContact turned = hertz_by_force(ratio * 1e-3, 1e-3, modulus, 5e4);
    EXPECT_EQ(turned.semi_axis_x, a.semi_axis_s);
    EXPECT_EQ(turned.approach, a.approach);
    EXPECT_NEAR(2.0 / 3 * std::numbers::pi * a.semi_axis_x * a.semi_axis_s * a.max_pressure, 5e4, 1e-8);
  }
}

TEST(Hertz, CurvaturesOfAnEllipseAreThoseWhoseEllipseItIs) {
  for (const double ratio : {0.02, 0.3, 0.99, 1.0, 1.5, 40.0}) {
    const HertzContact c = hertz_by_force(hertz_curvature_ratio(ratio) * 1e-3, 1e-3, modulus, 1e3);
    EXPECT_NEAR(c.semi_axis_x / c.semi_axis_s, ratio, 1e-9 * ratio);
  }
}

TEST(Hertz, LineContactIsTheLimitOfALongEllipse) {
  // At the middle of a long ellipse the force per length is pi/2 p0 b; the half width follows.
  const HertzContact c = hertz_by_force(1e-9, 1e-2, modulus, 5e4);
  const HertzLine line =
      hertz_line_by_force(50, modulus, std::numbers::pi / 2 * c.max_pressure * c.semi_axis_s);
  EXPECT_NEAR(line.half_width / c.semi_axis_s, 1, 1e-4);
  EXPECT_NEAR(hertz_line_by_half_width(50, modulus, line.half_width).force / line.force, 1, 1e-14);
}

TEST(Hertz, SteuermannsQuartic) {
  const QuarticContact c = steuermann_by_radius(1e-4, modulus, 3);
  EXPECT_NEAR(c.approach, 8.0 / 3 * 1e-4 * 81, 1e-15);
  EXPECT_NEAR(c.force, 64.0 / 15 * modulus * 1e-4 * 243, 1e-9);
  EXPECT_NEAR(steuermann_by_force(1e-4, modulus, c.force).radius, 3, 1e-14);
  // dF/d(approach) = 2 E* a for any axisymmetric punch (Barber 2018, eq. 5.34).
  const QuarticContact d = steuermann_by_radius(1e-4, modulus, 3 + 1e-6);
  EXPECT_NEAR((d.force - c.force) / (d.approach - c.approach), 2 * modulus * 3, 1e-6 * 2 * modulus * 3);
}

TEST(Hertz, CompressionFollowsTheGapInsideAndThePointForceFarAway) {
  for (const auto& [a, b] : {std::pair{1e-3, 1e-3}, {4e-4, 2e-3}, {5e-2, 1e-5}}) {
    const HertzContact c = hertz_by_force(a, b, modulus, 1e4);
    for (const double t : {0.0, 0.4, 1.3, 2.9})
      for (const double r : {0.0, 0.3, 0.8, 0.999}) {
        const double x = r * c.semi_axis_x * std::cos(t), s = r * c.semi_axis_s * std::sin(t);
        EXPECT_NEAR(hertz_compression(c, modulus, x, s), c.approach - a * x * x - b * s * s,
                    1e-9 * c.approach);
      }
    const double edge = hertz_compression(c, modulus, c.semi_axis_x * (1 + 1e-9), 0);
    EXPECT_NEAR(edge, c.approach - a * c.semi_axis_x * c.semi_axis_x, 1e-6 * c.approach) << "continuous";
    const double far = 1e3 * std::max(c.semi_axis_x, c.semi_axis_s);
    const double point = 1e4 / (std::numbers::pi * modulus * far); // Boussinesq
    EXPECT_NEAR(hertz_compression(c, modulus, 0.6 * far, 0.8 * far), point, 1e-5 * point);
  }
}

/// A circle outside, Johnson 1985, eq. 3.42a: p0/(2 E* a) ((2a^2 - r^2) asin(a/r) + r^2 (a/r) sqrt(1 -
/// a^2/r^2)).
TEST(Hertz, CompressionBesideACircle) {
  const HertzContact c = hertz_by_force(1e-3, 1e-3, modulus, 1e4);
  const double a = c.semi_axis_x;
  for (const double r : {1.01 * a, 1.5 * a, 4 * a}) {
    const double q = a / r;
    const double exact = c.max_pressure / (2 * modulus * a) *
                         ((2 * a * a - r * r) * std::asin(q) + r * r * q * std::sqrt(1 - q * q));
    EXPECT_NEAR(hertz_compression(c, modulus, 0.6 * r, 0.8 * r), exact, 1e-9 * c.approach);
  }
}

TEST(Hertz, RefusesWhatHasNoSolution) {
  EXPECT_THROW(hertz_by_force(0, 1e-3, modulus, 1), InputError);
  EXPECT_THROW(hertz_by_force(1e-3, 1e-3, modulus, std::nan("")), InputError);
  EXPECT_THAT(message_of([&] { hertz_by_approach(1e-3, 1e-3, modulus, -1); }),
              testing::HasSubstr("the approach is -1"));
}
