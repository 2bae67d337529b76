#include "bem_contact/table/contact_table.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::table {

namespace {

/// Between which points, and how far: 0 at the lower, 1 at the upper.
struct Place {
  std::size_t lower = 0;
  double share = 0;
};

Place place(std::span<const double> points, double at) {
  const auto above = std::ranges::upper_bound(points, at) - points.begin();
  const auto lower = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(points) - 2);
  const double from = points[lower], to = points[lower + 1];
  return {static_cast<std::size_t>(lower), std::clamp((at - from) / (to - from), 0.0, 1.0)};
}

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
  // corners of the cell: [first axis]...[last axis], two of each; each axis halves them
  std::vector<std::size_t> index{0};
  std::vector<double> weight{1};
  for (std::size_t a = 0; a < table.axes.size(); ++a) {
    const std::vector<double>& points = table.axes[a].points;
    const auto [lower, share] = place(points, at[a]);
    std::vector<std::size_t> next;
    std::vector<double> weights;
    for (std::size_t i = 0; i < index.size(); ++i)
      for (const std::size_t side : {0u, 1u}) {
        next.push_back(index[i] * points.size() + lower + side);
        weights.push_back(weight[i] * (side == 1 ? share : 1 - share));
      }
    index = std::move(next), weight = std::move(weights);
  }
  double value = 0;
  for (std::size_t i = 0; i < index.size(); ++i)
    if (weight[i] != 0) // a corner that does not count may be nan
      value += weight[i] * column.values[index[i]];
  return value;
}

double interpolate(std::span<const double> x, std::span<const double> y, double at) {
  const auto [lower, share] = place(x, at);
  return (1 - share) * y[lower] + share * y[lower + 1];
}

} // namespace bem_contact::table
