#include "bem_contact/contact/layer.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

bool SurfaceLayer::is_none() const {
  return normal == 0 && std::ranges::all_of(shear, [](double c) { return c == 0; });
}

bool SurfaceLayer::by_row() const {
  return std::ranges::any_of(shear, [this](double c) { return c != shear.front(); });
}

double SurfaceLayer::shear_of(int row) const {
  return shear.empty() ? 0 : shear.size() == 1 ? shear.front() : shear[row];
}

void add_layer(const SurfaceLayer& layer, InfluenceNumbers& numbers) {
  if (layer.shear.size() > 1 && layer.shear.size() != static_cast<std::size_t>(numbers.rows))
    throw InputError("The layer does not fit the influence numbers",
                     fmt::format("it has {} rows, and they have {}", layer.shear.size(), numbers.rows),
                     "Give one compliance, or one for each row.");
  std::vector<double> all = layer.shear;
  all.push_back(layer.normal);
  if (!std::ranges::all_of(all, [](double c) { return std::isfinite(c) && c >= 0; }))
    throw InputError("A compliance of the layer cannot be used", "it is negative or not finite",
                     "Give compliances of 0 mm^3/N or more.");
  if (layer.is_none())
    return;
  if (layer.by_row())
    numbers = with_every_pair_of_rows(numbers);
  // Of translational numbers one entry serves all rows.
  for (int row = 0; row < (numbers.translational ? 1 : numbers.rows); ++row) {
    numbers.at(0, row, component_x, row, component_x) += layer.shear_of(row);
    numbers.at(0, row, component_s, row, component_s) += layer.shear_of(row);
    numbers.at(0, row, component_n, row, component_n) += layer.normal;
  }
}

} // namespace bem_contact
