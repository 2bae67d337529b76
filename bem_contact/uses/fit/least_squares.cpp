#include "bem_contact/uses/fit/least_squares.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <unsupported/Eigen/NonLinearOptimization>

namespace bem_contact::fit {

namespace {

/// 1, of the unknown. Step of the differences: contact forces are known to 1e-8, and change by single
/// elements where steps are smaller.
constexpr double difference_step = 1e-2;
/// 1, of the scale of the unknown. Smallest value that such a step is taken of.
constexpr double smallest_of_scale = 0.1;
/// 1. Of first guesses, beside the given one.
constexpr double first_guesses[] = {0.1, 0.316, 3.16, 10};
/// 1, of the unknowns. The first step of the method is no longer: far away theories have no answer, or the
/// same one for all unknowns. Chosen.
constexpr double first_step = 0.5;
/// 1, of the unknowns. Two digits more than measurements have.
constexpr double tolerance = 1e-5;
/// Evaluations of one search, for each unknown.
constexpr int most_evaluations = 100;
/// Searches that begin again inside a bound.
constexpr int most_searches = 4;
/// 1. A residual where the theory has no answer, over the norm of what is measured: any step there is
/// refused.
constexpr double no_answer = 1e6;

using Vector = Eigen::VectorXd;

/// The theory, asked once for the same unknowns.
class Remembered {
public:
  Remembered(const Theory& theory, std::span<const Unknown> unknowns, const OwnSlopes& own_slopes = nullptr)
      : theory_(theory), own_slopes_(own_slopes), unknowns_(unknowns) {}

  const std::optional<std::vector<double>>& at(const std::vector<double>& values) {
    const auto known = known_.find(values);
    return known != known_.end() ? known->second : known_.emplace(values, theory_(values)).first->second;
  }
  std::optional<std::vector<double>> own_slopes(const std::vector<double>& values) {
    return own_slopes_ && at(values) ? own_slopes_(values) : std::nullopt;
  }
  int evaluations() const { return static_cast<int>(known_.size()); }
  std::span<const Unknown> unknowns() const { return unknowns_; }

  /// Unknowns over their scales, brought within their bounds.
  std::vector<double> within(const Vector& scaled) const {
    std::vector<double> out(unknowns_.size());
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = std::clamp(scaled[Eigen::Index(k)] * std::abs(unknowns_[k].start), unknowns_[k].at_least,
                          unknowns_[k].at_most);
    return out;
  }

private:
  const Theory& theory_;
  OwnSlopes own_slopes_;
  std::span<const Unknown> unknowns_;
  std::map<std::vector<double>, std::optional<std::vector<double>>> known_;
};

double step_of(const Unknown& unknown, double value) {
  return difference_step * std::max(std::abs(value), smallest_of_scale * std::abs(unknown.start));
}

/// The derivative of each point by one unknown; `both`: by central differences.
std::vector<double> slopes_by(Remembered& theory, const std::vector<double>& at, std::size_t k, bool both) {
  const Unknown& unknown = theory.unknowns()[k];
  const std::vector<double> here = theory.at(at).value();
  const double step = step_of(unknown, at[k]);
  const auto moved = [&](double by) {
    std::vector<double> there = at;
    there[k] = std::clamp(at[k] + by, unknown.at_least, unknown.at_most);
    const auto answer = there[k] == at[k] ? std::nullopt : theory.at(there);
    return std::pair(answer.value_or(here), answer ? there[k] : at[k]);
  };
  auto [up, upper] = moved(step);
  auto [down, lower] = std::pair(here, at[k]);
  if (both || upper == at[k])
    std::tie(down, lower) = moved(-step);
  std::vector<double> out(here.size());
  for (std::size_t i = 0; i < out.size() && upper > lower; ++i)
    out[i] = (up[i] - down[i]) / (upper - lower);
  return out;
}

std::vector<double> all_slopes(Remembered& theory, const std::vector<double>& at, bool both) {
  const std::size_t count = at.size(), points = theory.at(at).value().size();
  std::vector<double> out(points * count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::vector<double> column = slopes_by(theory, at, k, both);
    for (std::size_t i = 0; i < points; ++i)
      out[i * count + k] = column[i];
  }
  return out;
}

/// The problem as Eigen's method takes it: residuals over unknowns in their scales.
struct Problem {
  using Scalar = double;
  using InputType = Vector;
  using ValueType = Vector;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  Remembered& theory;
  const Points& points;

  int inputs() const { return static_cast<int>(theory.unknowns().size()); }
  int values() const { return static_cast<int>(points.size()); }

  double residual(std::size_t i, double computed) const {
    return points.weights[i] * (computed - points.measured[i]);
  }
  double sum_of_squares(const std::vector<double>& at) const {
    const auto& answer = theory.at(at);
    double sum = 0;
    for (std::size_t i = 0; answer && i < points.size(); ++i)
      sum += std::pow(residual(i, (*answer)[i]), 2);
    return answer ? sum : std::numeric_limits<double>::infinity();
  }
  int operator()(const Vector& scaled, Vector& out) const {
    const auto& answer = theory.at(theory.within(scaled));
    double norm = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      norm = std::hypot(norm, points.weights[i] * points.measured[i]);
    for (std::size_t i = 0; i < points.size(); ++i)
      out[Eigen::Index(i)] = answer ? residual(i, (*answer)[i]) : no_answer * std::max(norm, 1.0);
    return 0;
  }
  int df(const Vector& scaled, JacobianType& out) const {
    const std::vector<double> at = theory.within(scaled);
    const auto own = theory.own_slopes(at);
    const std::vector<double> slopes = own ? *own : all_slopes(theory, at, false);
    for (int i = 0; i < values(); ++i)
      for (int k = 0; k < inputs(); ++k) {
        const double asked = scaled[k] * std::abs(theory.unknowns()[std::size_t(k)].start);
        const double moves = asked == at[std::size_t(k)] ? 1 : 0; // beyond its bound it does nothing
        out(i, k) = moves * points.weights[std::size_t(i)] * slopes[std::size_t(i * inputs() + k)] *
                    std::abs(theory.unknowns()[std::size_t(k)].start);
      }
    return 0;
  }
};

/// The best of some first guesses of each positive unknown, one after the other.
std::vector<double> best_guess(const Problem& problem, std::span<const Unknown> unknowns) {
  std::vector<double> best;
  for (const Unknown& unknown : unknowns)
    best.push_back(std::clamp(unknown.start, unknown.at_least, unknown.at_most));
  double least = problem.sum_of_squares(best);
  if (!std::isfinite(least))
    throw InputError("The search has nothing to begin from", "the scene has no solution at the first guess",
                     "Give the scene values with which every measured point can be solved.");
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    for (const double factor : first_guesses) {
      std::vector<double> other = best;
      other[k] = factor * unknowns[k].start;
      if (unknowns[k].at_least < 0 || other[k] < unknowns[k].at_least || other[k] > unknowns[k].at_most)
        continue;
      if (const double sum = problem.sum_of_squares(other); sum < least)
        least = sum, best = other;
    }
  return best;
}

/// Puts unknowns that are at a bound, but fit better inside, inside. Says whether there are any.
bool leave_bounds(const Problem& problem, std::span<const Unknown> unknowns, std::vector<double>& values) {
  bool any = false;
  for (std::size_t k = 0; k < unknowns.size(); ++k) {
    const double inwards = values[k] <= unknowns[k].at_least ? 1 : values[k] >= unknowns[k].at_most ? -1 : 0;
    std::vector<double> inside = values;
    inside[k] += inwards * step_of(unknowns[k], values[k]);
    if (inwards != 0 && problem.sum_of_squares(inside) < problem.sum_of_squares(values))
      values = inside, any = true;
  }
  return any;
}

/// One search from `values`, which become what it found. Says whether it ended well.
bool search(Problem& problem, std::span<const Unknown> unknowns, std::vector<double>& values) {
  Eigen::LevenbergMarquardt<Problem> method(problem);
  method.parameters.factor = first_step;
  method.parameters.xtol = tolerance;
  method.parameters.ftol = tolerance * tolerance;
  method.parameters.maxfev = most_evaluations * problem.inputs();
  Vector scaled(problem.inputs());
  for (std::size_t k = 0; k < values.size(); ++k)
    scaled[Eigen::Index(k)] = values[k] / std::abs(unknowns[k].start);
  const auto ended = method.minimize(scaled);
  values = problem.theory.within(scaled);
  return ended != Eigen::LevenbergMarquardtSpace::TooManyFunctionEvaluation &&
         ended != Eigen::LevenbergMarquardtSpace::ImproperInputParameters;
}

} // namespace

std::vector<double> slopes_of(const Theory& theory, std::span<const Unknown> unknowns,
                              std::span<const double> at) {
  Remembered remembered(theory, unknowns);
  return all_slopes(remembered, {at.begin(), at.end()}, true);
}

Solution least_squares(const Theory& theory, const Points& points, std::span<const Unknown> unknowns,
                       const OwnSlopes& own_slopes) {
  Remembered remembered(theory, unknowns, own_slopes);
  Problem problem{remembered, points};
  Solution out;
  out.values = best_guess(problem, unknowns);
  for (int i = 0; i < most_searches; ++i) {
    out.converged = search(problem, unknowns, out.values);
    if (!leave_bounds(problem, unknowns, out.values))
      break;
  }
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    out.bounds.push_back(out.values[k] <= unknowns[k].at_least  ? Bound::lower
                         : out.values[k] >= unknowns[k].at_most ? Bound::upper
                                                                : Bound::none);
  out.computed = remembered.at(out.values).value();
  out.slopes = all_slopes(remembered, out.values, true);
  out.evaluations = remembered.evaluations();
  return out;
}

} // namespace bem_contact::fit
