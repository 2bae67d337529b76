#include "bem_contact/uses/shakedown/enclosing_ball.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::shakedown {

namespace {

/// 1. Radius less its lower bound over the radius at which a ball is good enough: far below the errors of
/// stresses.
constexpr double ball_tolerance = 2e-4;
/// 1. Bound of its steps; a path of 80 points takes some 100.
constexpr int most_ball_steps = 5000;

} // namespace

Ball smallest_ball(const DeviatorPath& path, const FreeComponents& free) {
  Deviator mask;
  for (int c = 0; c < 5; ++c)
    mask[c] = free[c];
  const std::size_t n = path.size();
  std::vector<double> weights(n, 0), squares(n);
  for (std::size_t i = 0; i < n; ++i)
    squares[i] = path[i].squaredNorm();
  const std::size_t first = std::ranges::max_element(squares) - squares.begin();
  weights[first] = 1;
  Ball ball{path[first].cwiseProduct(mask)};
  double mean_square = squares[first]; // sum of weights * squares
  const auto gradient = [&](std::size_t i) { return squares[i] - 2 * path[i].dot(ball.middle); };
  for (int step = 0; step < most_ball_steps; ++step) {
    std::size_t far = 0, near = first;
    double farthest = -1e300, nearest = 1e300;
    for (std::size_t i = 0; i < n; ++i) {
      const double g = gradient(i);
      if (g > farthest)
        farthest = g, far = i;
      if (weights[i] > 0 && g < nearest)
        nearest = g, near = i;
    }
    const double square = ball.middle.squaredNorm();
    ball.radius = std::sqrt(std::max(0.0, farthest + square));
    ball.least = std::sqrt(std::max(0.0, mean_square - square));
    if (ball.radius - ball.least <= ball_tolerance * ball.radius)
      break;
    const Deviator way = (path[far] - path[near]).cwiseProduct(mask);
    const double length = way.squaredNorm();
    const double most = weights[near];
    const double share = length > 0 ? std::min(most, (farthest - nearest) / (2 * length)) : most;
    weights[far] += share;
    weights[near] = share == most ? 0 : weights[near] - share;
    ball.middle += share * way;
    mean_square += share * (squares[far] - squares[near]);
  }
  return ball;
}

} // namespace bem_contact::shakedown
