#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/fit/bootstrap.hpp"
#include "bem_contact/uses/fit/least_squares.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fmt/core.h>
#include <random>

namespace {

using namespace bem_contact;
using namespace bem_contact::fit;

const std::vector<double> places{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};

std::optional<std::vector<double>> line(std::span<const double> u) {
  std::vector<double> out;
  for (const double x : places)
    out.push_back(u[0] + u[1] * x);
  return out;
}

/// Of height u0, length u1.
std::optional<std::vector<double>> saturation(std::span<const double> u) {
  if (!(u[1] > 0))
    return std::nullopt;
  std::vector<double> out;
  for (const double x : places)
    out.push_back(u[0] * (1 - std::exp(-x / u[1])));
  return out;
}

/// Its derivatives by both.
std::optional<std::vector<double>> slopes_of_saturation(std::span<const double> u) {
  std::vector<double> out;
  for (const double x : places) {
    const double left = std::exp(-x / u[1]);
    out.insert(out.end(), {1 - left, -u[0] * left * x / (u[1] * u[1])});
  }
  return out;
}

Points unweighted(std::vector<double> measured) {
  const std::size_t count = measured.size();
  return {std::move(measured), std::vector(count, 1.0)};
}

/// The regression line has closed forms: estimates, residuals, correlation.
TEST(LeastSquares, OfALineIsTheRegressionLine) {
  Points points = unweighted({1.2, 2.9, 5.3, 6.8, 9.1, 11.2, 12.7, 15.1, 17.0, 18.8});
  points.weights[3] = 2;
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double g = std::pow(points.weights[i], 2);
    w += g, x += g * places[i], y += g * points.measured[i];
    xx += g * places[i] * places[i], xy += g * places[i] * points.measured[i];
  }
  const double slope = (w * xy - x * y) / (w * xx - x * x), start = (y - slope * x) / w;
  const std::vector<Unknown> unknowns{{.start = 30}, {.start = -0.2}};
  const Solution s = least_squares(line, points, unknowns);
  EXPECT_TRUE(s.converged);
  EXPECT_NEAR(s.values[0], start, 1e-8);
  EXPECT_NEAR(s.values[1], slope, 1e-8);
  const Spread spread = bootstrap(s, points, unknowns);
  EXPECT_NEAR(spread.correlation[1], -x / std::sqrt(w * xx), 1e-6);
  EXPECT_EQ(spread.determined, (std::vector{true, true}));
}

/// A theory that knows its slopes is asked for fewer values, and the same are found. Where it does not know
/// them, differences serve.
TEST(LeastSquares, SearchesWithTheSlopesOfTheTheory) {
  const std::vector<Unknown> unknowns{{.start = 1, .at_least = 0}, {.start = 5, .at_least = 0}};
  const Points points = unweighted(*saturation(std::vector<double>{4, 2}));
  const auto found = [&](const OwnSlopes& own) { return least_squares(saturation, points, unknowns, own); };
  const Solution by_differences = found(nullptr), by_slopes = found(slopes_of_saturation),
                 by_none = found([](std::span<const double>) { return std::nullopt; });
  EXPECT_TRUE(by_slopes.converged);
  EXPECT_NEAR(by_slopes.values[0], 4, 1e-6);
  EXPECT_NEAR(by_slopes.values[1], 2, 1e-6);
  EXPECT_LE(by_slopes.evaluations, 0.7 * by_differences.evaluations);
  EXPECT_EQ(by_none.evaluations, by_differences.evaluations);
}

/// Where there is no scatter, the numbers come back, from guesses that are ten times off.
TEST(LeastSquares, FindsWhatWasPutIn) {
  const std::vector<double> true_values{4, 2};
  for (const double first : {0.3, 2.5, 30.0}) {
    const std::vector<Unknown> unknowns{{.start = first, .at_least = 0}, {.start = 8 / first, .at_least = 0}};
    const Solution s = least_squares(saturation, unweighted(*saturation(true_values)), unknowns);
    EXPECT_TRUE(s.converged) << first;
    EXPECT_NEAR(s.values[0], 4, 1e-5) << first;
    EXPECT_NEAR(s.values[1], 2, 1e-5) << first;
    EXPECT_EQ(s.bounds, (std::vector{Bound::none, Bound::none}));
  }
}

/// What the points ask for lies outside the range: the number stays at its end, the other one fits best
/// there.
TEST(LeastSquares, StaysWithinBounds) {
  const Points points = unweighted(*line(std::vector<double>{-3, 2}));
  for (const auto& [least, most, bound, value] :
       {std::tuple(1.0, 9.0, Bound::lower, 1.0), {-9.0, -4.0, Bound::upper, -4.0}}) {
    const std::vector<Unknown> unknowns{
        {.start = least == 1 ? 5.0 : -8.0, .at_least = least, .at_most = most}, {.start = 1}};
    const Solution s = least_squares(line, points, unknowns);
    EXPECT_EQ(s.bounds[0], bound);
    EXPECT_EQ(s.values[0], value);
    EXPECT_NEAR(s.values[1], (2 * 285 + (-3 - value) * 45) / 285, 1e-7); // sum x (y - value) / sum x^2
    const Spread spread = bootstrap(s, points, unknowns);
    EXPECT_GE(spread.low[0], least);
    EXPECT_LE(spread.high[0], most);
  }
}

/// A search that begins at the end of a range comes away from it.
TEST(LeastSquares, BeginsAtABound) {
  for (const double length : {0.7, 5.0}) {
    const std::vector<Unknown> unknowns{{.start = 41, .at_least = -100, .at_most = 41},
                                        {.start = length, .at_least = length < 2 ? 0.7 : 0, .at_most = 5}};
    const Solution s =
        least_squares(saturation, unweighted(*saturation(std::vector<double>{4, 2})), unknowns);
    EXPECT_NEAR(s.values[0], 4, 1e-4) << length;
    EXPECT_NEAR(s.values[1], 2, 1e-4) << length;
  }
}

TEST(LeastSquares, RefusesAFirstGuessWithoutAnswer) {
  const std::vector<Unknown> unknowns{{.start = 1}, {.start = -1}};
  EXPECT_THROW(least_squares(saturation, unweighted(places), unknowns), InputError);
}

/// 95 of 100 intervals contain what was put in, with ten points and with four.
TEST(Bootstrap, CoversWhatWasPutIn) {
  constexpr int seeds = 400;
  for (const std::size_t count : {std::size_t{10}, std::size_t{5}}) {
    const Theory some = [count](std::span<const double> u) {
      std::optional<std::vector<double>> out = line(u);
      out->resize(count);
      return out;
    };
    int inside = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      std::mt19937 random(static_cast<unsigned>(seed));
      std::normal_distribution<double> noise(0, 0.5);
      Points points = unweighted(*some(std::vector<double>{1, 2}));
      for (double& measured : points.measured)
        measured += noise(random);
      const std::vector<Unknown> unknowns{{.start = 1}, {.start = 1}};
      const Spread spread = bootstrap(least_squares(some, points, unknowns), points, unknowns);
      inside += spread.low[1] <= 2 && 2 <= spread.high[1];
    }
    fmt::print("{} points: {} of {} intervals contain the slope\n", count, inside, seeds);
    EXPECT_GE(inside, seeds * 90 / 100) << count;
    EXPECT_LE(inside, seeds * 99 / 100) << count;
  }
}

TEST(Bootstrap, TellsWhatNoPointDependsOn) {
  const std::vector<Unknown> unknowns{{.start = 1}, {.start = 1}, {.start = 1}};
  const Points points = unweighted({1, 3, 5.1, 7, 9, 11, 13, 14.9, 17, 19});
  const Spread spread = bootstrap(least_squares(line, points, unknowns), points, unknowns);
  EXPECT_EQ(spread.determined, (std::vector{true, true, false}));
  EXPECT_TRUE(std::isnan(spread.low[2]));
  EXPECT_LT(spread.high[1] - spread.low[1], 0.1);
}

} // namespace
