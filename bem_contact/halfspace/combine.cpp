#include "bem_contact/halfspace/combine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::halfspace {

InfluenceNumbers combine(InfluenceNumbers lower, const InfluenceNumbers& upper) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= same_grid * std::max(std::abs(a), std::abs(b));
  };
  if (lower.offsets != upper.offsets || lower.rows != upper.rows || !same(lower.dx, upper.dx) ||
      !same(lower.ds, upper.ds))
    throw InputError("the influence numbers of two bodies cannot be added", "they belong to different grids",
                     "expand both for the same grid");
  if (lower.translational != upper.translational)
    return combine(spelled_out(lower), spelled_out(upper));
  // Either form has threes [j] of a row after each other, and three or more such rows [i].
  const std::size_t threes = lower.translational ? 1 : static_cast<std::size_t>(lower.rows);
  double* to = lower.values.data();
  const double* add = upper.values.data();
  for (std::size_t row = 0; row < lower.values.size() / (3 * threes); ++row) {
    const double sign = row % 3 == component_x ? 1 : -1;
    for (std::size_t three = 0; three < threes; ++three, to += 3, add += 3) {
      to[component_x] += sign * add[component_x];
      to[component_s] -= sign * add[component_s];
      to[component_n] -= sign * add[component_n];
    }
  }
  return lower;
}

} // namespace bem_contact::halfspace
