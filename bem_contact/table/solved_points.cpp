#include "bem_contact/table/solved_points.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/table/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>

namespace bem_contact::table {

void SolvedPoints::ask(std::span<const Point> points) {
  std::set<Point> missing;
  for (const Point& point : points)
    if (!known_.contains(point))
      missing.insert(point);
  const std::vector<Point> asked(missing.begin(), missing.end());
  const std::vector<PointValues> answers = solve_(asked);
  for (std::size_t i = 0; i < asked.size(); ++i)
    known_[asked[i]] = answers[i];
}

void SolvedPoints::fill(ContactTable& table) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < table.size(); ++i)
    points.push_back(table.point(i));
  ask(points);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    Column& column = table.columns[c];
    column.values.clear();
    column.element_error = std::numeric_limits<double>::quiet_NaN();
    for (const Point& point : points) {
      const PointValues& at = known_.at(point);
      column.values.push_back(at.values[c]);
      column.element_error = std::fmax(column.element_error, at.element_errors[c]);
    }
    if (column.held && std::ranges::any_of(column.values, [](double v) { return !std::isfinite(v); }))
      throw InputError(fmt::format("{} cannot be held within the tolerance", column.name),
                       "a point of the table has no such number", "Take it out of table.hold.");
  }
}

std::string WorstError::text(const ContactTable& table) const {
  std::string where;
  for (std::size_t a = 0; a < table.axes.size(); ++a)
    where += fmt::format("{}{} = {:.6g}", a == 0 ? "" : ", ", table.axes[a].name, at[a]);
  return fmt::format("{} is still off by {:.3g} % at {}", table.columns[column].name, 100 * relative, where);
}

void require_room(const ContactTable& table, const Wanted& wanted, int round, const WorstError& worst) {
  const std::size_t points = table.size();
  if (points <= wanted.most_points && round < most_rounds)
    return;
  if (round == 0)
    throw InputError(fmt::format("The table begins with {} points", points),
                     fmt::format("{} are allowed", wanted.most_points),
                     "Give fewer points on the axes, or allow more with --most-points.");
  throw ConvergenceError(
      fmt::format("The table is not within {:g} %", 100 * wanted.tolerance),
      fmt::format("{}, and the next refinement takes {} points where {} are allowed", worst.text(table),
                  points, wanted.most_points),
      "Allow a larger error with --tolerance or more points with --most-points, shorten the axes, or take "
      "out of table.hold what jumps there.");
}

} // namespace bem_contact::table
