#include "bem_contact/fatigue/fatigue_columns.hpp"

namespace bem_contact::fatigue {

std::span<const PatchColumn> patch_columns() {
  using P = PatchFatigue;
  static constexpr PatchColumn columns[] = {
      {"s", "mm", [](const P& p) { return p.s; }},
      {"y", "mm", [](const P& p) { return p.y; }},
      {"Fn", "N", [](const P& p) { return p.normal_force; }},
      {"pmax", "MPa", [](const P& p) { return p.pmax; }},
      {"p0_over_k", "1", [](const P& p) { return p.point.load; }},
      {"mu_used", "1", [](const P& p) { return p.point.traction; }},
      {"FI_surf", "1", [](const P& p) { return p.surface_index; }},
      {"FI_worst_element", "1", [](const P& p) { return p.largest_index; }},
      {"T_gamma", "N", [](const P& p) { return p.t_gamma; }},
      {"damage", "1", [](const P& p) { return p.damage; }}};
  return columns;
}

} // namespace bem_contact::fatigue
