#include "bem_contact/halfspace/combine.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::halfspace {

InfluenceNumbers combine(const InfluenceNumbers& lower, const InfluenceNumbers& upper) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= same_grid * std::max(std::abs(a), std::abs(b));
  };
  if (lower.offsets != upper.offsets || lower.rows != upper.rows || !same(lower.dx, upper.dx) ||
      !same(lower.ds, upper.ds))
    throw InputError("the influence numbers of two bodies cannot be added", "they belong to different grids",
                     "expand both for the same grid");
  if (lower.translational != upper.translational)
    return combine(spelled_out(lower), spelled_out(upper));
  InfluenceNumbers result = lower;
  for (int m = 0; m < lower.offsets; ++m)
    for (const auto& [row_i, row_j] : lower.stored_rows())
      for (int i = 0; i < 3; ++i) {
        const int sign = i == component_x ? 1 : -1;
        double* to = &result.at(m, row_i, i, row_j, 0);
        const double* add = &upper.values[upper.index(m, row_i, i, row_j, 0)];
        to[component_x] += sign * add[component_x];
        to[component_s] -= sign * add[component_s];
        to[component_n] -= sign * add[component_n];
      }
  return result;
}

} // namespace bem_contact::halfspace
