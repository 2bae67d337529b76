#include "bem_contact/uses/fit/bootstrap.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <random>
#include <utility>

namespace bem_contact::fit {

namespace {

/// Draws: the ends of an interval are known to some 3 % of its width.
constexpr int draw_count = 2000;
constexpr std::uint64_t seed = 1979;
constexpr double tail = 0.025; ///< beyond each end of an interval of 95 %
/// 1. An unknown that moves no point by this share of what is measured, if it changes by itself, is not
/// determined by the points.
constexpr double least_effect = 1e-5;

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

double quantile(std::vector<double> values, double share) {
  const double place = share * double(values.size() - 1);
  const auto below = std::size_t(place);
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(below));
  const double low = values[below];
  const double high = below + 1 < values.size()
                          ? *std::min_element(values.begin() + std::ptrdiff_t(below) + 1, values.end())
                          : low;
  return low + (place - double(below)) * (high - low);
}

/// The linear problem at the solution: residuals r - J d over the changes d of the determined unknowns, in
/// their scales.
struct Linear {
  Matrix slopes;                     ///< [point][determined unknown], weighted
  Vector residuals;                  ///< weighted
  Vector lower, upper;               ///< bounds of the changes
  std::vector<std::size_t> unknowns; ///< which unknown each is
};

Linear linear_of(const Solution& solution, const Points& points, std::span<const Unknown> unknowns) {
  Linear out;
  const auto n = Eigen::Index(points.size());
  out.residuals.resize(n);
  double size = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = std::size_t(i);
    out.residuals[i] = points.weights[at] * (points.measured[at] - solution.computed[at]);
    size = std::hypot(size, points.weights[at] * points.measured[at]);
  }
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double scale = std::abs(unknowns[k].start);
    Vector column(n);
    for (Eigen::Index i = 0; i < n; ++i)
      column[i] = points.weights[std::size_t(i)] * solution.slope(std::size_t(i), k) * scale;
    if (!(column.norm() * std::max(1.0, std::abs(solution.values[k]) / scale) > least_effect * size))
      continue;
    const Eigen::Index last = out.slopes.cols();
    out.slopes.conservativeResize(n, last + 1);
    out.slopes.col(last) = column;
    out.lower.conservativeResize(last + 1);
    out.upper.conservativeResize(last + 1);
    out.lower[last] = (unknowns[k].at_least - solution.values[k]) / scale;
    out.upper[last] = (unknowns[k].at_most - solution.values[k]) / scale;
    out.unknowns.push_back(k);
  }
  return out;
}

/// Least squares with each point counted `times`, and what leaves its bounds held there. Nothing where the
/// points drawn do not determine all.
std::optional<Vector> step_of_draw(const Linear& linear, const Vector& times) {
  const Eigen::Index count = linear.slopes.cols();
  const Matrix normal = linear.slopes.transpose() * times.asDiagonal() * linear.slopes;
  const Vector right = linear.slopes.transpose() * times.asDiagonal() * linear.residuals;
  Vector step = Vector::Zero(count);
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < count; ++k)
    free.push_back(k);
  while (!free.empty()) {
    const Eigen::ColPivHouseholderQR<Matrix> solver(normal(free, free));
    if (solver.rank() < Eigen::Index(free.size()))
      return std::nullopt;
    Vector held = step;
    held(free).setZero();
    const Vector found = solver.solve(Vector(right(free) - (normal * held)(free)));
    std::vector<Eigen::Index> inside;
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Eigen::Index k = free[i];
      step[k] = std::clamp(found[Eigen::Index(i)], linear.lower[k], linear.upper[k]);
      if (step[k] == found[Eigen::Index(i)])
        inside.push_back(k);
    }
    if (inside.size() == free.size())
      break;
    free = std::move(inside);
  }
  return step;
}

/// What a draw is stretched by.
double stretch(std::size_t points, std::size_t unknowns) {
  const double rest = double(points) - double(unknowns);
  const double student = boost::math::quantile(boost::math::students_t(rest), 1 - tail),
               normal = boost::math::quantile(boost::math::normal(), 1 - tail);
  return std::sqrt(double(points) / rest) * student / normal;
}

std::vector<double> correlation_of(const Linear& linear, std::size_t count) {
  std::vector<double> out(count * count);
  for (std::size_t k = 0; k < count; ++k)
    out[k * count + k] = 1;
  if (linear.unknowns.empty())
    return out;
  const Matrix covariance =
      (linear.slopes.transpose() * linear.slopes).completeOrthogonalDecomposition().pseudoInverse();
  for (std::size_t i = 0; i < linear.unknowns.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto a = Eigen::Index(i), b = Eigen::Index(j);
      const double r = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
      out[linear.unknowns[i] * count + linear.unknowns[j]] = r;
      out[linear.unknowns[j] * count + linear.unknowns[i]] = r;
    }
  return out;
}

} // namespace

Spread bootstrap(const Solution& solution, const Points& points, std::span<const Unknown> unknowns) {
  const Linear linear = linear_of(solution, points, unknowns);
  const std::size_t n = points.size(), count = unknowns.size();
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  Spread out{std::vector(count, unknown), std::vector(count, unknown),
             std::vector(count, unknown), {},
             std::vector(count, false),   {}};
  out.correlation = correlation_of(linear, count);
  for (const std::size_t k : linear.unknowns)
    out.determined[k] = true;
  if (linear.unknowns.empty() || linear.unknowns.size() >= n)
    return out;
  const double wider = stretch(n, linear.unknowns.size());
  std::mt19937_64 random(seed); // the same on every machine; a distribution of the library is not
  for (int draw = 0; draw < draw_count; ++draw) {
    Vector times = Vector::Zero(Eigen::Index(n));
    for (std::size_t i = 0; i < n; ++i)
      times[Eigen::Index(random() % n)] += 1;
    const std::optional<Vector> step = step_of_draw(linear, times);
    if (!step)
      continue;
    std::vector<double>& values = out.draws.emplace_back(solution.values);
    for (std::size_t i = 0; i < linear.unknowns.size(); ++i) {
      const std::size_t k = linear.unknowns[i];
      values[k] = std::clamp(values[k] + wider * (*step)[Eigen::Index(i)] * std::abs(unknowns[k].start),
                             unknowns[k].at_least, unknowns[k].at_most);
    }
  }
  for (const std::size_t k : linear.unknowns) {
    std::vector<double> values;
    double squares = 0;
    for (const std::vector<double>& draw : out.draws) {
      values.push_back(draw[k]);
      squares += std::pow(draw[k] - solution.values[k], 2);
    }
    if (values.empty())
      continue;
    out.low[k] = quantile(values, tail);
    out.high[k] = quantile(values, 1 - tail);
    out.standard_error[k] = std::sqrt(squares / double(values.size()));
  }
  return out;
}

std::pair<double, double> band_of(const Spread& spread, std::span<const double> solution, double middle,
                                  std::span<const double> slopes) {
  std::vector<double> values;
  for (const std::vector<double>& draw : spread.draws) {
    double value = middle;
    for (std::size_t k = 0; k < slopes.size(); ++k)
      value += slopes[k] * (draw[k] - solution[k]);
    values.push_back(value);
  }
  if (values.empty())
    return {middle, middle};
  return {quantile(values, tail), quantile(values, 1 - tail)};
}

} // namespace bem_contact::fit
