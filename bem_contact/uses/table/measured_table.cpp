#include "bem_contact/uses/table/measured_table.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace bem_contact::table {

void MeasuredTable::ask(std::span<const Point> points) {
  std::set<Point> missing;
  for (const Point& point : points)
    if (!known_.contains(point))
      missing.insert(point);
  const std::vector<Point> asked(missing.begin(), missing.end());
  const std::vector<PointValues> answers = solve_(asked);
  for (std::size_t i = 0; i < asked.size(); ++i)
    known_[asked[i]] = answers[i];
}

namespace {

/// 1. Rounds, as a guard: each inserts a point at least, and 200 points on an axis are no table.
constexpr int most_rounds = 200;

[[noreturn]] void refuse_to_hold(const Column& column) {
  throw InputError(fmt::format("{} cannot be held within the tolerance", column.name),
                   "a point of the table has no such number", "Take it out of table.hold.");
}

} // namespace

void MeasuredTable::fill(int round) {
  require_room(round);
  if (wanted_.progress)
    wanted_.progress(fmt::format("{} points{}", table_.size(), round == 0 ? "" : "; " + worst_text()));
  std::vector<Point> points;
  for (std::size_t i = 0; i < table_.size(); ++i)
    points.push_back(table_.point(i));
  ask(points);
  for (std::size_t c = 0; c < table_.columns.size(); ++c) {
    Column& column = table_.columns[c];
    column.values.clear();
    column.element_error = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : points) {
      const PointValues& at = known_.at(point);
      column.values.push_back(at.values[c]);
      column.element_error = std::fmax(column.element_error, at.element_errors[c]);
    }
    if (column.held && std::ranges::any_of(column.values, [](double v) { return !std::isfinite(v); }))
      refuse_to_hold(column);
  }
  if (wanted_.rescale)
    wanted_.rescale(table_);
}

double MeasuredTable::off(const Point& at, std::size_t column) const {
  return std::abs(interpolate(table_, table_.columns[column], at) - known_.at(at).values[column]);
}

WorstError MeasuredTable::error(const Point& at) const {
  WorstError worst{.at = at};
  for (std::size_t c = 0; c < table_.columns.size(); ++c)
    if (const Column& column = table_.columns[c]; column.held) {
      const double relative = off(at, c) / column.scale;
      if (std::isnan(relative))
        refuse_to_hold(column);
      if (relative > worst.relative)
        worst.relative = relative, worst.column = c;
    }
  return worst;
}

std::vector<WorstError> MeasuredTable::measure(std::span<const Point> middles) {
  ask(middles);
  for (std::size_t c = 0; c < table_.columns.size(); ++c) {
    double& largest = table_.columns[c].interpolation_error = 0;
    for (const Point& middle : middles)
      largest = std::fmax(largest, off(middle, c)); // leaves nan out
  }
  table_.tolerance = wanted_.tolerance;
  table_.checked = middles.size();
  table_.solved = known_.size();
  std::vector<WorstError> wrong;
  worst_.relative = 0;
  for (const Point& middle : middles) {
    const WorstError here = error(middle);
    if (here.relative > wanted_.tolerance)
      wrong.push_back(here);
    if (here.relative > worst_.relative)
      worst_ = here;
  }
  return wrong;
}

std::string MeasuredTable::worst_text() const {
  std::string where;
  for (std::size_t a = 0; a < table_.axes.size(); ++a)
    where += fmt::format("{}{} = {:.6g}", a == 0 ? "" : ", ", table_.axes[a].name, worst_.at[a]);
  return fmt::format("{} is still off by {:.3g} % at {}", table_.columns[worst_.column].name,
                     100 * worst_.relative, where);
}

void MeasuredTable::require_room(int round) const {
  const std::size_t points = table_.size();
  if (points <= wanted_.most_points && round < most_rounds)
    return;
  if (round == 0)
    throw InputError(fmt::format("The table begins with {} points", points),
                     fmt::format("{} are allowed", wanted_.most_points),
                     "Give fewer points on the axes, or allow more with --most-points.");
  throw ConvergenceError(
      fmt::format("The table is not within {:g} %", 100 * wanted_.tolerance),
      fmt::format("{}, and the next refinement takes {} points where {} are allowed", worst_text(), points,
                  wanted_.most_points),
      "Allow a larger error with --tolerance or more points with --most-points, shorten the axes, or take "
      "out of table.hold what jumps there.");
}

} // namespace bem_contact::table
