#include "bem_contact/table/contact_table.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::table {

namespace {

/// The interval of a coordinate: between points[lower] and the next.
std::size_t interval(std::span<const double> points, double at) {
  const auto above = std::ranges::upper_bound(points, at) - points.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(points) - 2));
}

/// The slope at a point between two intervals of lengths h and k, along which the slopes are f and g: that of
/// the parabola through the three points.
double parabola_slope(double h, double f, double k, double g) {
  return (k * f + h * g) / (h + k);
}

/// What is left of a table once the coordinates of some axes are given.
struct Remainder {
  const ContactTable& table;
  const Column& column;
  std::span<const double> at;

  /// `index`: of the points of the axes before this one.
  double value(std::size_t axis, std::size_t index) const {
    if (axis == at.size())
      return column.values[index];
    const std::vector<double>& x = table.axes[axis].points;
    const std::size_t i = interval(x, at[axis]);
    const auto point = [&](std::size_t k) { return value(axis + 1, index * x.size() + k); };
    const double h = x[i + 1] - x[i], share = std::clamp((at[axis] - x[i]) / h, 0.0, 1.0);
    if (share == 0 || share == 1)
      return point(share == 0 ? i : i + 1);
    const double low = point(i), high = point(i + 1), slope = (high - low) / h;
    double first = slope, last = slope;
    if (i > 0)
      first = parabola_slope(x[i] - x[i - 1], (low - point(i - 1)) / (x[i] - x[i - 1]), h, slope);
    if (i + 2 < x.size())
      last = parabola_slope(h, slope, x[i + 2] - x[i + 1], (point(i + 2) - high) / (x[i + 2] - x[i + 1]));
    if (i == 0) // at an end the parabola of the neighbours goes on
      first = 2 * slope - last;
    if (i + 2 == x.size())
      last = 2 * slope - first;
    return low + share * h * (slope + (1 - share) * ((first - slope) * (1 - share) - (last - slope) * share));
  }
};

} // namespace

std::size_t ContactTable::size() const {
  std::size_t n = 1;
  for (const Axis& axis : axes)
    n *= axis.points.size();
  return n;
}

std::vector<double> ContactTable::point(std::size_t index) const {
  std::vector<double> out(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    out[a] = axes[a].points[index % axes[a].points.size()];
    index /= axes[a].points.size();
  }
  return out;
}

const Column& ContactTable::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &Column::name);
  if (found != columns.end())
    return *found;
  std::vector<std::string_view> names;
  for (const Column& c : columns)
    names.push_back(c.name);
  throw InputError(fmt::format("The table has no '{}'", name),
                   fmt::format("it has {}", fmt::join(names, ", ")), "Use one of these.");
}

double interpolate(const ContactTable& table, const Column& column, std::span<const double> at) {
  if (at.size() != table.axes.size())
    throw InputError(fmt::format("A point with {} coordinates is not in the table", at.size()),
                     fmt::format("it has {} axes", table.axes.size()), "Give one for each axis.");
  return Remainder{table, column, at}.value(0, 0);
}

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  const std::size_t i = interval(x, at);
  const double share = std::clamp((at - x[i]) / (x[i + 1] - x[i]), 0.0, 1.0);
  return (1 - share) * y[i] + share * y[i + 1];
}

} // namespace bem_contact::table
