#include "bem_contact/uses/table/contact_table.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::table {

namespace {

/// 1, of the length of an axis: a coordinate so little beyond its end is the end. Quotients and logarithms
/// leave the last of 16 digits open.
constexpr double axis_slack = 1e-12;

/// The interval of a coordinate: between points[lower] and the next.
std::size_t interval(std::span<const double> points, double at) {
  const auto above = std::ranges::upper_bound(points, at) - points.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(points) - 2));
}

/// The points of one axis that make the value at a coordinate: up to four neighbours.
struct AxisWeights {
  std::size_t first = 0, count = 0;
  std::array<double, 4> weights{};
};

AxisWeights axis_weights(std::span<const double> x, double at) {
  if (x.size() == 1)
    return {0, 1, {1}};
  const std::size_t i = interval(x, at);
  const double h = x[i + 1] - x[i], share = std::clamp((at - x[i]) / h, 0.0, 1.0);
  if (share == 0 || share == 1) // a point of the table: what its neighbours are does not matter
    return {share == 0 ? i : i + 1, 1, {1}};
  const bool before = i > 0, after = i + 2 < x.size();
  // The cubic is the chord + low (slope at the lower end - chord's) - high (slope at the upper end -
  // chord's). At an end of the axis the parabola of the other side goes on: there both differences are
  // opposite numbers.
  double low = h * share * (1 - share) * (1 - share), high = h * share * share * (1 - share);
  if (!before)
    high += low;
  if (!after)
    low += high;
  std::array<double, 4> w{0, 1 - share, share, 0};
  // The slope of a parabola between intervals of lengths h and k differs from the chord over h by h/(h + k)
  // times the difference of both chords.
  if (before) {
    const double k = x[i] - x[i - 1], factor = low * h / (h + k);
    w[0] -= factor / k;
    w[1] += factor / k + factor / h;
    w[2] -= factor / h;
  }
  if (after) {
    const double k = x[i + 2] - x[i + 1], factor = high * h / (h + k);
    w[1] -= factor / h;
    w[2] += factor / h + factor / k;
    w[3] -= factor / k;
  }
  if (!before) // no point comes first
    std::rotate(w.begin(), w.begin() + 1, w.end());
  return {before ? i - 1 : i, 2 + std::size_t{before} + std::size_t{after}, w};
}

} // namespace

AxisLine Axis::line(std::size_t before) const {
  if (first.empty())
    return {points, before * points.size()};
  return {{points.data() + first[before], first[before + 1] - first[before]}, first[before]};
}

double Axis::from() const {
  return first.empty() ? points.front() : points[first[first.size() - 2]];
}

double Axis::to() const {
  return points.back();
}

std::size_t ContactTable::size() const {
  std::size_t n = 1;
  for (const Axis& axis : axes)
    n = axis.first.empty() ? n * axis.points.size() : axis.points.size();
  return n;
}

bool ContactTable::nested() const {
  return std::ranges::any_of(axes, [](const Axis& axis) { return !axis.first.empty(); });
}

std::vector<double> ContactTable::point(std::size_t index) const {
  std::vector<double> out(axes.size());
  for (std::size_t a = axes.size(); a-- > 0;) {
    const Axis& axis = axes[a];
    if (axis.first.empty()) {
      out[a] = axis.points[index % axis.points.size()];
      index /= axis.points.size();
    } else {
      out[a] = axis.points[index];
      index = static_cast<std::size_t>(std::ranges::upper_bound(axis.first, index) - axis.first.begin() - 1);
    }
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

void require_coordinates(const ContactTable& table, std::size_t count) {
  if (count != table.axes.size())
    throw InputError(
        fmt::format("A point with {} is not in the table", counted(count, "coordinate", "coordinates")),
        "it has " + counted(table.axes.size(), "axis", "axes"), "Give one for each axis.");
}

std::vector<PointWeight> weights_at(const ContactTable& table, std::span<const double> at) {
  require_coordinates(table, at.size());
  std::vector<PointWeight> out{{0, 1}};
  for (std::size_t a = 0; a < at.size(); ++a) {
    std::vector<PointWeight> finer;
    finer.reserve(4 * out.size());
    for (const PointWeight& coarse : out) {
      const AxisLine line = table.axes[a].line(coarse.index);
      const AxisWeights axis = axis_weights(line.points, at[a]);
      for (std::size_t k = 0; k < axis.count; ++k)
        finer.push_back({line.first + axis.first + k, coarse.weight * axis.weights[k]});
    }
    out = std::move(finer);
  }
  return out;
}

double interpolate(const Column& column, std::span<const PointWeight> weights) {
  double sum = 0;
  for (const PointWeight& point : weights)
    sum += point.weight * column.values[point.index];
  return sum;
}

double interpolate(const ContactTable& table, const Column& column, std::span<const double> at) {
  return interpolate(column, weights_at(table, at));
}

void require_inside(const Axis& axis, double at) {
  const double from = axis.from(), to = axis.to(), slack = axis_slack * (to - from);
  if (at >= from - slack && at <= to + slack) // not for nan
    return;
  throw InputError(
      fmt::format("{} = {:.9g} is outside the table", axis.name, at),
      fmt::format("its axis goes from {:.9g} to {:.9g}{}", from, to, axis.unit == "1" ? "" : " " + axis.unit),
      "Stay within, or make a table with a longer axis.");
}

std::vector<double> look_up(const ContactTable& table, std::span<const double> at) {
  const std::vector<PointWeight> weights = weights_at(table, at);
  for (std::size_t a = 0; a < at.size(); ++a)
    require_inside(table.axes[a], at[a]);
  std::vector<double> out;
  for (const Column& column : table.columns)
    out.push_back(interpolate(column, weights));
  return out;
}

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  const std::size_t i = interval(x, at);
  const double share = std::clamp((at - x[i]) / (x[i + 1] - x[i]), 0.0, 1.0);
  return (1 - share) * y[i] + share * y[i + 1];
}

} // namespace bem_contact::table
