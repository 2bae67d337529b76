#include "bem_contact/app/stresses_output.hpp"

#include "bem_contact/app/datasets.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

using nlohmann::json;

json stresses_json(const std::optional<StressesBelow>& stresses) {
  if (!stresses)
    return nullptr;
  json tensor = json::array();
  for (const halfspace::Stress& t : stresses->stress)
    tensor.push_back({t.xx, t.ss, t.nn, t.xs, t.xn, t.sn});
  return {{"x", stresses->x},
          {"s", stresses->s},
          {"depths", stresses->depths},
          {"components", {"xx", "ss", "nn", "xs", "xn", "sn"}},
          {"stress", tensor},
          {"von_mises", stresses->von_mises},
          {"largest_shear", stresses->largest_shear}};
}

std::string stresses_text(const std::optional<StressesBelow>& stresses) {
  if (!stresses || stresses->largest_shear.empty())
    return "";
  const StressesBelow& b = *stresses;
  const auto at =
      static_cast<std::size_t>(std::ranges::max_element(b.largest_shear) - b.largest_shear.begin());
  const std::size_t nd = b.depths.size(), ns = b.s.size();
  return fmt::format(
      "below the surface: largest shear stress {:.1f} MPa (von Mises {:.1f}) at x = {:g}, s = {:g}, "
      "depth {:g} mm, of {} points\n",
      b.largest_shear[at], b.von_mises[at], b.x[at / nd / ns], b.s[at / nd % ns], b.depths[at % nd],
      b.largest_shear.size());
}

void add_stresses(H5Table& table, const std::string& group, const StressesBelow& b) {
  table.datasets[group + "x"] = line(b.x, "mm", "x of the points");
  table.datasets[group + "s"] = line(b.s, "mm", "arc length of the points along the rail");
  table.datasets[group + "depths"] = line(b.depths, "mm", "depth of the points below the surface, along n");
  const std::vector<std::size_t> shape{b.x.size(), b.s.size(), b.depths.size()};
  table.datasets[group + "von_mises"] = {shape, b.von_mises, "MPa", "von Mises' stress [x][s][depth]"};
  table.datasets[group + "largest_shear"] = {shape, b.largest_shear, "MPa", "largest shear stress"};
  H5Dataset tensor{shape, {}, "MPa", "xx, ss, nn, xs, xn, sn; tension positive; half-space closed forms"};
  tensor.shape.push_back(6);
  for (const halfspace::Stress& t : b.stress)
    tensor.values.insert(tensor.values.end(), {t.xx, t.ss, t.nn, t.xs, t.xn, t.sn});
  table.datasets[group + "stress"] = std::move(tensor);
}

} // namespace bem_contact::app
