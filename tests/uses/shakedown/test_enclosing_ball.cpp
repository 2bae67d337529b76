#include "bem_contact/uses/shakedown/enclosing_ball.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace bem_contact;
using namespace bem_contact::shakedown;

DeviatorPath random_path(std::mt19937& random, int points) {
  std::normal_distribution<double> normal;
  DeviatorPath path(points);
  for (Deviator& d : path)
    for (int c = 0; c < 5; ++c)
      d[c] = normal(random);
  return path;
}

/// The slow way: the middle goes a little towards the farthest point, less and less (Badoiu and Clarkson
/// 2003).
double slow_radius(const DeviatorPath& path, const FreeComponents& free) {
  Deviator middle = Deviator::Zero();
  double radius = 0;
  for (int i = 1; i < 20000; ++i) {
    const Deviator* far = &path.front();
    for (const Deviator& d : path)
      if ((d - middle).norm() > (*far - middle).norm())
        far = &d;
    radius = (*far - middle).norm();
    for (int c = 0; c < 5; ++c)
      if (free[c])
        middle[c] += ((*far)[c] - middle[c]) / (i + 1.0);
  }
  return radius;
}

TEST(SmallestBall, OfTwoPointsAndOfOne) {
  DeviatorPath path{Deviator(1, 2, 3, 4, 5), Deviator(1, 2, 3, 4, 11)};
  const Ball ball = smallest_ball(path);
  EXPECT_NEAR(ball.radius, 3, 1e-4);
  EXPECT_NEAR(ball.middle[4], 8, 1e-3);
  path.pop_back();
  EXPECT_EQ(smallest_ball(path).radius, 0);
}

/// The corners of a regular simplex lie on a ball of radius sqrt(n / (2 (n + 1))) times its edge.
TEST(SmallestBall, OfASimplex) {
  DeviatorPath path;
  for (int i = 0; i < 5; ++i)
    path.push_back(std::sqrt(0.5) * Deviator::Unit(i));
  EXPECT_NEAR(smallest_ball(path).radius, std::sqrt(4.0 / 10), 2e-4);
}

TEST(SmallestBall, AsTheSlowWay) {
  std::mt19937 random(7);
  for (int i = 0; i < 2; ++i) {
    const DeviatorPath path = random_path(random, 30);
    for (const FreeComponents& free : {all_free, {true, true, false, false, true}}) {
      const Ball ball = smallest_ball(path, free);
      const double slow = slow_radius(path, free);
      EXPECT_NEAR(ball.radius, slow, 1e-3 * slow);
      EXPECT_LE(ball.least, ball.radius);
      EXPECT_GE(ball.least, (1 - 2.1e-4) * ball.radius);
    }
  }
}

/// Only what is free moves the middle: without any, the ball is about the origin.
TEST(SmallestBall, WithNothingFree) {
  const DeviatorPath path{Deviator(3, 0, 4, 0, 0), Deviator(1, 0, 0, 0, 0)};
  EXPECT_DOUBLE_EQ(smallest_ball(path, {false, false, false, false, false}).radius, 5);
  EXPECT_NEAR(smallest_ball(path, {true, false, false, false, false}).radius, 4, 1e-4);
}

} // namespace
