#include "bem_contact/halfspace/combine.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::halfspace {

namespace {

/// 1. Two bodies whose element sizes differ by less, relatively, have the same grid: rounding.
constexpr double same_grid = 1e-9;

} // namespace

InfluenceNumbers combine(const InfluenceNumbers& lower, InfluenceNumbers upper) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= same_grid * std::max(std::abs(a), std::abs(b));
  };
  if (lower.offsets != upper.offsets || lower.rows != upper.rows || !same(lower.dx, upper.dx) ||
      !same(lower.ds, upper.ds))
    throw InputError("The influence numbers of two bodies cannot be added", "they belong to different grids",
                     "Expand both for the same grid.");
  if (lower.translational != upper.translational)
    return combine(with_every_pair_of_rows(lower), with_every_pair_of_rows(upper));
  // Either form has threes [j] of a row after each other, and three or more such rows [i].
  const std::size_t threes = lower.translational ? 1 : static_cast<std::size_t>(lower.rows);
  double* to = upper.values.data();
  const double* from = lower.values.data();
  for (std::size_t row = 0; row < upper.values.size() / (3 * threes); ++row) {
    const double sign = row % 3 == component_x ? 1 : -1;
    for (std::size_t three = 0; three < threes; ++three, to += 3, from += 3) {
      to[component_x] = from[component_x] + sign * to[component_x];
      to[component_s] = from[component_s] - sign * to[component_s];
      to[component_n] = from[component_n] - sign * to[component_n];
    }
  }
  return upper;
}

InfluenceNumbers combine_equal(InfluenceNumbers body) {
  if (!body.translational)
    throw InputError("Influence numbers cannot be those of both bodies", "they depend on both rows",
                     "Combine the numbers of each body.");
  for (std::size_t block = 0; block < body.values.size(); block += 9)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        double &a = body.values[block + 3 * i + j], &b = body.values[block + 3 * j + i];
        a = b = a + b;
      }
  return body;
}

} // namespace bem_contact::halfspace
