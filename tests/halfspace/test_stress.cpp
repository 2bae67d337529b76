#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/stress.hpp"
#include "tests/halfspace/quadrature.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace bem_contact;
using namespace bem_contact::halfspace;

using std::numbers::pi;
constexpr double Stress::*components[] = {&Stress::xx, &Stress::ss, &Stress::nn,
                                          &Stress::xs, &Stress::xn, &Stress::sn};

/// Point force P along n (Boussinesq 1885; Johnson 1985, eqs 3.18, 3.19).
Stress boussinesq(double nu, double x, double y, double z) {
  const double q = x * x + y * y, r = std::sqrt(q + z * z), r3 = r * r * r, r5 = r3 * r * r, c = 1 / (2 * pi);
  const double l = (1 - 2 * nu) / q, flat = (1 - z / r) / q;
  return {c * (l * (flat * (x * x - y * y) + z * y * y / r3) - 3 * z * x * x / r5),
          c * (l * (flat * (y * y - x * x) + z * x * x / r3) - 3 * z * y * y / r5),
          -3 * c * z * z * z / r5,
          c * (l * (flat * 2 * x * y - z * x * y / r3) - 3 * x * y * z / r5),
          -3 * c * x * z * z / r5,
          -3 * c * y * z * z / r5};
}

/// Point force Q along x (Cerruti 1882; Johnson 1985, eqs 3.76).
Stress cerruti(double nu, double x, double y, double z) {
  const double r = std::sqrt(x * x + y * y + z * z), r2 = r * r, r3 = r2 * r, r5 = r3 * r2, w = r + z,
               c = 1 / (2 * pi);
  const double a = 1 / (r3 * w * w), b = 2 / (r2 * w * w * w), g = 1 / (r * w * w), k = 1 - 2 * nu;
  return {c * (-3 * x * x * x / r5 + k * (x / r3 - 3 * x * g + x * x * x * (a + b))),
          c * (-3 * x * y * y / r5 + k * (x / r3 - x * g + x * y * y * (a + b))),
          -3 * c * x * z * z / r5,
          c * (-3 * x * x * y / r5 + k * (-y * g + x * x * y * (a + b))),
          -3 * c * x * x * z / r5,
          -3 * c * x * y * z / r5};
}

/// Cerruti's force along s: axes exchanged.
Stress cerruti_along_s(double nu, double x, double y, double z) {
  const Stress t = cerruti(nu, y, x, z);
  return {t.ss, t.xx, t.nn, t.xs, t.sn, t.xn};
}

TEST(RectangleStress, IsTheIntegralOfPointForces) {
  const double a = 0.7, b = 0.4;
  const GaussRule rule(40);
  struct Point {
    double x, s, n;
  };
  for (const double nu : {0.0, 0.28, 0.5})
    for (const Point& at : {Point{0.1, -0.05, 0.5}, Point{0.9, 0.2, 0.3}, Point{-0.3, 1.1, 0.6},
                            Point{2, -3, 0.8}, Point{-0.7, 0.4, 0.4}, Point{0.7, 0.1, 2}}) {
      std::array<Stress, 3> sum{};
      for (int p = 0; p < 40; ++p)
        for (int q = 0; q < 40; ++q) {
          const double weight = a * b * rule.weight[p] * rule.weight[q];
          // shifted by an irrational nothing: Boussinesq's formula is 0/0 straight below the force
          const double x = at.x - a * rule.point[p] + 1e-13, s = at.s - b * rule.point[q];
          sum[0].add(weight, cerruti(nu, x, s, at.n));
          sum[1].add(weight, cerruti_along_s(nu, x, s, at.n));
          sum[2].add(weight, boussinesq(nu, x, s, at.n));
        }
      const auto closed = rectangle_stress(nu, at.x, at.s, at.n, a, b);
      for (int j = 0; j < 3; ++j)
        for (const auto component : components)
          EXPECT_NEAR(closed[j].*component, sum[j].*component, 1e-9) << j << ' ' << at.x << ' ' << nu;
    }
}

/// div sigma = 0, by central differences whose error falls with the square of the step.
TEST(RectangleStress, IsInEquilibrium) {
  const double x = 0.5, s = -0.3, n = 0.4, nu = 0.3;
  const auto at = [&](int axis, double h) {
    return rectangle_stress(nu, x + (axis == 0) * h, s + (axis == 1) * h, n + (axis == 2) * h, 0.7, 0.4);
  };
  for (int j = 0; j < 3; ++j)
    for (const double h : {2e-2, 1e-2}) {
      const auto derivative = [&](double Stress::*c, int axis) {
        return (at(axis, h)[j].*c - at(axis, -h)[j].*c) / (2 * h);
      };
      const double bound = 10 * h * h;
      using S = Stress;
      EXPECT_NEAR(derivative(&S::xx, 0) + derivative(&S::xs, 1) + derivative(&S::xn, 2), 0, bound);
      EXPECT_NEAR(derivative(&S::xs, 0) + derivative(&S::ss, 1) + derivative(&S::sn, 2), 0, bound);
      EXPECT_NEAR(derivative(&S::xn, 0) + derivative(&S::sn, 1) + derivative(&S::nn, 2), 0, bound);
    }
}

TEST(RectangleStress, AtTheSurfaceIsTheTractionApplied) {
  for (const auto& [x, s, inside] :
       {std::tuple{0.2, 0.1, 1.0}, std::tuple{0.9, 0.1, 0.0}, std::tuple{-1.0, 2.0, 0.0}}) {
    const auto t = rectangle_stress(0.28, x, s, 1e-9, 0.7, 0.4);
    EXPECT_NEAR(t[2].nn, -inside, 1e-7);
    EXPECT_NEAR(t[0].xn, -inside, 1e-7);
    EXPECT_NEAR(t[1].sn, -inside, 1e-7);
    for (const double other : {t[2].xn, t[2].sn, t[0].nn, t[0].sn, t[1].nn, t[1].xn})
      EXPECT_NEAR(other, 0, 1e-7);
  }
}

/// Far away, sums over corners cancel; the point force tells how much is left.
TEST(RectangleStress, FarAwayIsAPointForce) {
  const double x = 60, s = -40, n = 30;
  const auto closed = rectangle_stress(0.28, x, s, n, 0.5, 0.5);
  const Stress points[] = {cerruti(0.28, x, s, n), cerruti_along_s(0.28, x, s, n), boussinesq(0.28, x, s, n)};
  for (int j = 0; j < 3; ++j)
    for (const auto component : components)
      EXPECT_NEAR(closed[j].*component, points[j].*component, 2e-4 * von_mises(points[j]));
}

/// Love 1929: below the middle of a uniform square sigma_n = -(2 p/pi)(atan(ab/zR) + abz/R (1/(a2+z2) +
/// 1/(b2+z2))).
TEST(RectangleStress, CentreLineOfARectangle) {
  const double a = 2, b = 1;
  for (const double z : {0.1, 1.0, 5.0}) {
    const double r = std::sqrt(a * a + b * b + z * z);
    const double expected =
        -2 / pi * (std::atan(a * b / (z * r)) + a * b * z / r * (1 / (a * a + z * z) + 1 / (b * b + z * z)));
    EXPECT_NEAR(rectangle_stress(0.3, 0, 0, z, a, b)[2].nn, expected, 1e-13);
  }
}

/// Uniform pressure on a circle of radius 1 (Johnson 1985, section 3.4), of squares.
TEST(RectangleStress, CentreLineOfACircle) {
  const double nu = 0.3;
  double before = 0;
  for (const int across : {20, 80}) {
    const double h = 2.0 / across;
    double worst = 0;
    for (const double z : {0.5, 1.0}) {
      Stress sum;
      for (int i = 0; i < across; ++i)
        for (int j = 0; j < across; ++j) {
          const double x = -1 + (i + 0.5) * h, s = -1 + (j + 0.5) * h;
          if (x * x + s * s < 1)
            sum.add(1, rectangle_stress(nu, -x, -s, z, h / 2, h / 2)[2]);
        }
      const double c = z / std::sqrt(1 + z * z);
      worst = std::max({worst, std::abs(sum.nn + 1 - c * c * c),
                        std::abs(sum.xx + 0.5 * ((1 + 2 * nu) - 2 * (1 + nu) * c + c * c * c)),
                        std::abs(sum.xx - sum.ss), std::abs(sum.xs)});
    }
    if (across > 20) {
      EXPECT_LT(worst, before / 4) << "whole squares: the area's error falls with h or faster";
      EXPECT_LT(worst, 3e-3);
    }
    before = worst;
  }
}

/// Hertz on a circle, nu 0.3: tau_max 0.310 p0 at z = 0.48 a (Johnson 1985, section 4.2).
TEST(RectangleStress, LargestShearUnderHertzCircle) {
  const int across = 40;
  const double h = 2.0 / across;
  double largest = 0, depth = 0;
  for (double z = 0.02; z < 1; z += 0.02) {
    Stress sum;
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j) {
        const double x = -1 + (i + 0.5) * h, s = -1 + (j + 0.5) * h, q = 1 - x * x - s * s;
        if (q > 0)
          sum.add(std::sqrt(q), rectangle_stress(0.3, -x, -s, z, h / 2, h / 2)[2]);
      }
    if (largest_shear(sum) > largest) {
      largest = largest_shear(sum);
      depth = z;
    }
    // Johnson 1985, eq. 3.45
    EXPECT_NEAR(sum.nn, -1 / (1 + z * z), 4e-3) << z;
    EXPECT_NEAR(sum.xx, -1.3 * (1 - z * std::atan(1 / z)) + 0.5 / (1 + z * z), 4e-3) << z;
    EXPECT_NEAR(von_mises(sum), 2 * largest_shear(sum), 1e-9) << "two equal principal stresses";
  }
  EXPECT_NEAR(largest, 0.310, 0.002);
  EXPECT_NEAR(depth, 0.48, 0.021);
}

/// Hertz's line contact: tau_max 0.300 p0 at z = 0.786 b; endless strips, sigma_x = nu
/// (sum).
TEST(RectangleStress, LargestShearUnderALineContact) {
  const int across = 80;
  const double h = 2.0 / across;
  double largest = 0, depth = 0;
  for (double z = 0.5; z < 1.1; z += 0.01) {
    Stress sum;
    for (int j = 0; j < across; ++j) {
      const double s = -1 + (j + 0.5) * h;
      sum.add(std::sqrt(1 - s * s), rectangle_stress(0.3, 0, -s, z, 1e6, h / 2)[2]);
    }
    EXPECT_NEAR(sum.xx, 0.3 * (sum.ss + sum.nn), 1e-6);
    if (largest_shear(sum) > largest) {
      largest = largest_shear(sum);
      depth = z;
    }
  }
  EXPECT_NEAR(largest, 0.300, 0.001);
  EXPECT_NEAR(depth, 0.786, 0.011);
}

TEST(StressInvariants, OfKnownStates) {
  EXPECT_NEAR(von_mises({3, 3, 3, 0, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(largest_shear({3, 3, 3, 0, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(largest_shear({4, -1, 2, 0, 0, 0}), 2.5, 1e-14);
  EXPECT_NEAR(von_mises({5, 0, 0, 0, 0, 0}), 5, 1e-14);
  for (const Stress& shear : {Stress{0, 0, 0, 7, 0, 0}, Stress{0, 0, 0, 0, 7, 0}, Stress{0, 0, 0, 0, 0, 7}}) {
    EXPECT_NEAR(largest_shear(shear), 7, 1e-13);
    EXPECT_NEAR(von_mises(shear), 7 * std::sqrt(3.0), 1e-13);
  }
  // principal values 1, 2, 4, turned about n
  const double c = std::cos(0.5), s = std::sin(0.5);
  EXPECT_NEAR(largest_shear({c * c + 4 * s * s, s * s + 4 * c * c, 2, -3 * c * s, 0, 0}), 1.5, 1e-13);
}

TEST(RectangleStress, RefusesTheSurface) {
  EXPECT_THROW(rectangle_stress(0.3, 0, 0, 0, 1, 1), InputError);
  EXPECT_THROW(rectangle_stress(0.3, 0, 0, -1, 1, 1), InputError);
  EXPECT_THROW(rectangle_stress(0.3, 0, std::nan(""), 1, 1, 1), InputError);
  EXPECT_THROW(rectangle_stress(0.3, 0, 0, 1, 0, 1), InputError);
}

} // namespace
