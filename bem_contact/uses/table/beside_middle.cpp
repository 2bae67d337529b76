#include "bem_contact/uses/table/beside_middle.hpp"

#include "bem_contact/base/lagrange.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::table {

namespace {

/// Where h t (1 - t) (1 - 2 t), the error by slopes that are off alike, is largest: 1/2 -+ 1 / (2 sqrt(3)) of
/// the interval.
constexpr double off_most[] = {0.5 - 0.5 / std::numbers::sqrt3, 0.5 + 0.5 / std::numbers::sqrt3};
/// An error that is largest in the middle, as 4 t (1 - t), is so much of it there.
constexpr double left_of_middle = 2.0 / 3;

using Weights = std::array<double, 4>;

/// By how much the interpolation between the two inner points exceeds the cubic through all four.
Weights beyond_cubic(std::span<const double> four, double share) {
  const double at = std::lerp(four[1], four[2], share);
  Weights out{};
  lagrange_weights(four, at, out);
  for (double& weight : out)
    weight = -weight;
  const ContactTable line{.axes = {{"", "", "", {four.begin(), four.end()}}}};
  for (const PointWeight& point : weights_at(line, {&at, 1}))
    out[point.index] += point.weight;
  return out;
}

} // namespace

std::vector<double> beside_middle(const ContactTable& table, const Point& middle, std::size_t axis) {
  std::vector<double> out(table.columns.size(), 0.0);
  const std::vector<double>& points = table.axes[axis].points;
  const std::ptrdiff_t lower = std::ranges::upper_bound(points, middle[axis]) - points.begin() - 1;
  if (table.nested() || lower < 1 || lower + 2 >= std::ssize(points))
    return out;
  const std::span four(points.data() + lower - 1, 4);
  std::vector<double> values(4 * out.size());
  Point at = middle;
  for (std::size_t k = 0; k < four.size(); ++k) {
    at[axis] = four[k];
    const std::vector<PointWeight> weights = weights_at(table, at);
    for (std::size_t c = 0; c < out.size(); ++c)
      values[4 * c + k] = interpolate(table.columns[c], weights);
  }
  const Weights in_middle = beyond_cubic(four, 0.5);
  for (const double share : off_most) {
    const Weights there = beyond_cubic(four, share);
    for (std::size_t c = 0; c < out.size(); ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < four.size(); ++k)
        sum += (there[k] - left_of_middle * in_middle[k]) * values[4 * c + k];
      out[c] = std::fmax(out[c], std::abs(sum)); // leaves nan out
    }
  }
  return out;
}

double in_cell(double in_middle, double beside) {
  return std::fmax(in_middle, left_of_middle * in_middle + beside);
}

} // namespace bem_contact::table
