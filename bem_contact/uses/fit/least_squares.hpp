#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::fit {

/// A number that is looked for.
struct Unknown {
  double start = 1; ///< first guess, not 0: its magnitude is the scale of the number
  double at_least = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
};

/// Which of its bounds a number was stopped by.
enum class Bound { none, lower, upper };

/// What is measured, and one over the standard deviation of each point; without known ones all 1.
struct Points {
  std::vector<double> measured, weights;

  std::size_t size() const { return measured.size(); }
};

/// What a theory says at each point, for given unknowns. Nothing: it has no answer there.
using Theory = std::function<std::optional<std::vector<double>>(std::span<const double> unknowns)>;

/// Derivatives of what a theory said last for these unknowns, [point][unknown], where it knows them itself.
/// Nothing: differences of the theory have to do.
using OwnSlopes = std::function<std::optional<std::vector<double>>(std::span<const double> unknowns)>;

/// The unknowns for which the sum of the squares of weight (measured - computed) is smallest.
struct Solution {
  std::vector<double> values;   ///< one an unknown
  std::vector<Bound> bounds;    ///< one an unknown
  std::vector<double> computed; ///< one a point
  std::vector<double> slopes;   ///< [point][unknown]: derivatives of `computed`, by central differences
  int evaluations = 0;          ///< of the theory
  bool converged = false;

  double slope(std::size_t point, std::size_t unknown) const {
    return slopes[point * values.size() + unknown];
  }
};

/// Derivatives of a theory at unknowns within their bounds, [point][unknown], by central differences; at a
/// bound, and where the theory has no answer on one side, by one-sided ones.
std::vector<double> slopes_of(const Theory& theory, std::span<const Unknown> unknowns,
                              std::span<const double> at);

/// Levenberg and Marquardt's method (More 1978, in Eigen), from the best of some first guesses: those that
/// are positive are tried at a tenth to ten times of what is given. A number that would leave its bounds
/// stays at them. The search takes `own_slopes` where there are any; those of the Solution are differences,
/// which even out what single elements do. Throws InputError where the theory has no answer at the first
/// guess.
Solution least_squares(const Theory& theory, const Points& points, std::span<const Unknown> unknowns,
                       const OwnSlopes& own_slopes = nullptr);

} // namespace bem_contact::fit
