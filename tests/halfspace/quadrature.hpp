#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

/// Gauss-Legendre by Newton on the Legendre polynomial: the tests' own, apart from the library's tables.
struct GaussRule {
  std::vector<double> point, weight;
  explicit GaussRule(int n) {
    for (int i = 0; i < n; ++i) {
      double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), derivative = 1;
      for (int iteration = 0; iteration < 50; ++iteration) {
        double p0 = 1, p1 = x;
        for (int k = 2; k <= n; ++k)
          p0 = std::exchange(p1, ((2 * k - 1) * x * p1 - (k - 1) * p0) / k);
        derivative = n * (x * p1 - p0) / (x * x - 1);
        const double step = p1 / derivative;
        x -= step;
        if (std::abs(step) < 1e-16)
          break;
      }
      point.push_back(x);
      weight.push_back(2 / ((1 - x * x) * derivative * derivative));
    }
  }
};

/// Integral over [from, to] with points crowded at both ends, for integrands with logarithms there.
template <class Function> double integrate(double from, double to, int n, Function&& f) {
  const GaussRule rule(n);
  double sum = 0;
  for (int g = 0; g < n; ++g) {
    const double t = (1 + rule.point[g]) / 2;
    const double position = t * t * t * (10 - 15 * t + 6 * t * t);
    const double slope = 30 * t * t * (1 - t) * (1 - t);
    sum += rule.weight[g] / 2 * slope * f(from + (to - from) * position);
  }
  return (to - from) * sum;
}
