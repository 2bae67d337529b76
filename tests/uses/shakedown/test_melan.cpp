#include "bem_contact/uses/shakedown/enclosing_ball.hpp"
#include "bem_contact/uses/shakedown/melan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;

/// Stresses below a Hertz line contact across x that slips all over, over p0; x and z over its half width
/// (McEwen 1949: Johnson 1985, eqs. 4.49 and 7.8), nu = 0.28.
halfspace::Stress line_stress(double x, double z, double mu) {
  const double sum = 1 - x * x + z * z, size = std::hypot(sum, 2 * x * z), m = std::sqrt((size + sum) / 2),
               n = std::copysign(std::sqrt(std::max(size - sum, 0.0) / 2), x), q = m * m + n * n;
  const double tau = -n * (m * m - z * z) / q, along = -(m * (1 + (z * z + n * n) / q) - 2 * z);
  const double xx = along + mu * (n * (2 - (z * z - m * m) / q) - 2 * x),
               nn = -m * (1 - (z * z + n * n) / q) + mu * tau;
  return {xx, 0.28 * (xx + nn), nn, 0, tau + mu * along, 0};
}

/// A depth below the line. Residual stresses xx and ss may be anything at each depth: ss is a field of its
/// own.
YieldPoint below_line(double z, double mu, int number) {
  YieldPoint out;
  out.fields = {{number}, {unit_ss()}};
  for (int i = -250; i <= 250; ++i)
    out.path.push_back(deviator(line_stress(0.01 * i, z, mu)));
  return out;
}

struct LineLimit {
  double mu, limit, depth, residual;
};

/// p0/k, z/a and residual xx/k as found by two programs that share nothing with this one. The optimum is
/// flat: a tenth of the residual stress moves the limit in the fourth digit. xx is the difference to nn,
/// which is 0.
TEST(Melan, LineContactThatSlipsAllOver) {
  for (const LineLimit& right : {LineLimit{0, 4.000, 0.50, -0.536}, LineLimit{0.1, 3.564, 0.46, -0.346},
                                 LineLimit{0.2, 3.202, 0.42, -0.167}, LineLimit{0.3, 2.900, 0.38, 0.017}}) {
    std::vector<YieldPoint> points;
    std::vector<double> depths;
    for (double z = 0.3; z < 0.6; z += 0.02) {
      points.push_back(below_line(z, right.mu, static_cast<int>(points.size())));
      depths.push_back(z);
    }
    const MelanLoad found = largest_load(points, static_cast<int>(points.size()));
    EXPECT_TRUE(found.converged);
    EXPECT_NEAR(found.factor, right.limit, 1e-3 * right.limit);
    EXPECT_GE(found.bound, found.factor);
    EXPECT_LE(found.bound, (1 + 2e-4) * found.factor);
    const std::size_t at = std::ranges::max_element(found.work) - found.work.begin();
    EXPECT_NEAR(depths[at], right.depth, 0.021) << right.mu;
    const halfspace::Stress residual = stress_of(found.residual[at]);
    EXPECT_NEAR(residual.xx - residual.nn, right.residual, 0.05) << right.mu;
  }
}

/// From mu = 0.367 the surface decides: p0/k = 1/mu. There von Mises' condition also knows ss, which
/// Poisson's ratio varies along x, and bears a little less.
TEST(Melan, SurfaceOfALine) {
  for (const double mu : {0.4, 0.5}) {
    const MelanLoad found = largest_load({below_line(0.45, mu, 0), below_line(1e-9, mu, 1)}, 2);
    EXPECT_GT(found.work[1], 0.99);
    EXPECT_LE(found.factor, (1 + 1e-4) / mu);
    EXPECT_GT(found.factor, 0.85 / mu);
  }
}

std::vector<YieldPoint> random_points(int points, int fields) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<YieldPoint> out(points);
  const auto any = [&] {
    Deviator d;
    for (double& value : d)
      value = normal(random);
    return d;
  };
  for (YieldPoint& p : out) {
    for (int j = 0; j < 12; ++j)
      p.path.push_back(any());
    for (int f = 0; f < fields; ++f) {
      p.fields.fields.push_back(f);
      p.fields.stress.push_back(0.3 * any());
    }
  }
  return out;
}

/// Both theorems by what they say: the stresses bear the factor, and no other residual stress bears the
/// bound.
TEST(Melan, WhatItFindsHolds) {
  const std::vector<YieldPoint> points = random_points(15, 8);
  const MelanLoad found = largest_load(points, 8);
  ASSERT_TRUE(found.converged);
  double largest = 0, ball_limit = 1e300;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Deviator residual = found.xx[i] * unit_xx();
    for (std::size_t f = 0; f < 8; ++f)
      residual += found.coefficients[f] * points[i].fields.stress[f];
    EXPECT_NEAR((residual - found.residual[i]).norm(), 0, 1e-9);
    for (const Deviator& d : points[i].path)
      largest = std::max(largest, (found.factor * d + residual).norm());
    ball_limit = std::min(ball_limit, 1 / smallest_ball(points[i].path).least);
  }
  EXPECT_LE(largest, 1 + 1e-9);
  EXPECT_GT(largest, 1 - 1e-3);
  EXPECT_LT(found.factor, ball_limit);
  EXPECT_NEAR(found.bound, found.factor, 2e-4 * found.factor);
}

/// Twice the path bears half the load; and where a point is free of all fields, its ball decides.
TEST(Melan, ScalesAndReachesTheBall) {
  std::vector<YieldPoint> points = random_points(3, 4);
  const double before = largest_load(points, 4).factor;
  for (YieldPoint& p : points)
    for (Deviator& d : p.path)
      d *= 2;
  EXPECT_NEAR(largest_load(points, 4).factor, before / 2, 1e-3 * before);

  YieldPoint free = random_points(1, 0).front();
  for (int c = 0; c < 5; ++c) {
    free.fields.fields.push_back(c);
    free.fields.stress.push_back(Deviator::Unit(c));
  }
  EXPECT_NEAR(largest_load({free}, 5).factor, 1 / smallest_ball(free.path).radius, 5e-4);
}

} // namespace
