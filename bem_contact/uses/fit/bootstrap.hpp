#pragma once

#include "bem_contact/uses/fit/least_squares.hpp"

#include <span>
#include <vector>

namespace bem_contact::fit {

/// How far the points let the unknowns move.
struct Spread {
  std::vector<double> low, high;          ///< ends of the intervals of 95 %; nan where no point depends on it
  std::vector<double> standard_error;     ///< the same
  std::vector<double> correlation;        ///< [unknown][unknown], of the estimates; 1 on the diagonal
  std::vector<bool> determined;           ///< whether any point depends on it
  std::vector<std::vector<double>> draws; ///< [draw][unknown]: what they might be, within their bounds
};

/// Bootstrap of the points (Efron 1979): as many points are drawn with repetition, and each draw gives
/// unknowns by one step of Gauss and Newton from the solution (Shao and Tu 1995, section 2.2.4), without
/// solving again. Few points scatter less than what they stand for, so the draws are stretched by sqrt(n / (n
/// - p)) and Student's quantile over the normal one (Hesterberg 2015, "expanded percentiles"). n: points, p:
/// unknowns that they determine. The draws are the same each time.
Spread bootstrap(const Solution& solution, const Points& points, std::span<const Unknown> unknowns);

/// The 2.5 and 97.5 % quantiles of what a number becomes with each draw: `middle` and its derivatives by the
/// unknowns.
std::pair<double, double> band_of(const Spread& spread, std::span<const double> solution, double middle,
                                  std::span<const double> slopes);

} // namespace bem_contact::fit
