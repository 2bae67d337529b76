#pragma once

#include "bem_contact/uses/shakedown/shakedown_of_result.hpp"

#include <array>

namespace bem_contact::shakedown {

/// The numbers of a patch, in the order of the outputs, of anything that is one.
template <class P> std::span<const ColumnOf<P>> columns_of_patch() {
  static constexpr std::array<ColumnOf<P>, 22> columns{
      {{"s", "mm", "centre of pressure, arc length along the rail", [](const P& p) { return p.s; }},
       {"y", "mm", "centre of pressure, track frame; nan where stresses were given",
        [](const P& p) { return p.y; }, Missing::possible},
       {"pmax", "MPa", "largest pressure", [](const P& p) { return p.pmax; }},
       {"yields", "1", "0 never, 1 once, 2 for ever, 3: once or for ever",
        [](const P& p) { return double(p.yielding); }},
       {"first_yield", "1", "load factor up to which nothing yields",
        [](const P& p) { return p.first_yield.value; }},
       {"first_yield_s", "mm", "where it does first", [](const P& p) { return p.first_yield.s; }},
       {"first_yield_depth", "mm", "how deep", [](const P& p) { return p.first_yield.depth; }},
       {"shakedown", "1", "load factor up to which it shakes down (lower bound)",
        [](const P& p) { return p.lower.value; }},
       {"shakedown_upper", "1", "load factor from which it does not (upper bound)",
        [](const P& p) { return p.upper.value; }},
       {"shakedown_s", "mm", "where that is decided", [](const P& p) { return p.lower.s; }},
       {"shakedown_depth", "mm", "how deep; 0: at the surface", [](const P& p) { return p.lower.depth; }},
       {"p0_over_k_limit", "1", "pmax over k at the lower bound",
        [](const P& p) { return p.limit_pressure(); }},
       {"p0_over_k_upper", "1", "pmax over k at the upper bound",
        [](const P& p) { return p.limit_pressure() * p.upper.value / p.lower.value; }},
       {"dang_van", "MPa", "largest shear stress of Dang Van below the surface",
        [](const P& p) { return p.dang_van.value; }},
       {"dang_van_s", "mm", "where that is", [](const P& p) { return p.dang_van.s; }},
       {"dang_van_depth", "mm", "how deep", [](const P& p) { return p.dang_van.depth; }},
       {"dang_van_surface", "MPa", "the same on the surface", [](const P& p) { return p.dang_van_surface; }},
       {"crossland", "MPa", "largest stress of Crossland below the surface",
        [](const P& p) { return p.crossland.value; }},
       {"crossland_s", "mm", "where that is", [](const P& p) { return p.crossland.s; }},
       {"crossland_depth", "mm", "how deep", [](const P& p) { return p.crossland.depth; }},
       {"fatigue_share", "1", "Dang Van's largest stress over the fatigue limit in torsion; nan: not given",
        [](const P& p) { return p.fatigue_share(); }, Missing::possible},
       {"fatigue_damage", "1", "of one passage there after Miner; a crack begins at 1",
        [](const P& p) { return p.damage(); }, Missing::possible}}};
  return columns;
}

/// What steel it is, as every answer says it.
record::Record properties_record(const ShakedownProperties& properties);

} // namespace bem_contact::shakedown
