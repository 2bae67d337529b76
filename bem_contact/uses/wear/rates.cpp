#include "bem_contact/uses/wear/rates.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/gravity.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::wear {

namespace {

constexpr double kilometre = 1e6; // mm
constexpr double million = 1e6;
constexpr double tonne = 1e3; // kg

constexpr ColumnOf<WearRates> columns[] = {
    {"T_gamma", "N", "work of friction per rolled distance", [](const WearRates& w) { return w.t_gamma; }},
    {"wheel_depth_per_km", "mm", "off the wheel at the deepest row, by km",
     [](const WearRates& w) { return w.wheel_depth; }},
    {"wheel_area_per_km", "mm2", "gone from the wheel's section, by km",
     [](const WearRates& w) { return w.wheel_area; }},
    {"rail_depth_per_million_axles", "mm", "off the rail at the deepest row, by a million axles",
     [](const WearRates& w) { return w.rail_depth; }},
    {"rail_area_per_million_axles", "mm2", "gone from the rail's section, by a million axles",
     [](const WearRates& w) { return w.rail_area; }},
    {"axle_load", "t", "mass on the axle", [](const WearRates& w) { return w.axle_load; }},
    {"rail_depth_per_mgt", "mm", "off the rail at the deepest row, by a million gross tonnes",
     [](const WearRates& w) { return w.mgt_rail_depth; }},
    {"rail_area_per_mgt", "mm2", "gone from the rail's section, by a million gross tonnes",
     [](const WearRates& w) { return w.mgt_rail_area; }},
};

/// One row of elements.
struct RowWear {
  double rail_s = 0, wheel_s = 0, rail = 0, wheel = 0, sliding = 0;
};

constexpr ColumnOf<RowWear> row_columns[] = {
    {"s", "mm", "arc length on the rail", [](const RowWear& r) { return r.rail_s; }},
    {"wheel_s", "mm", "arc length on the wheel", [](const RowWear& r) { return r.wheel_s; }},
    {"rail_depth_per_million_axles", "mm", "off the rail", [](const RowWear& r) { return r.rail; }},
    {"wheel_depth_per_km", "mm", "off the wheel", [](const RowWear& r) { return r.wheel; }},
    {"sliding", "mm", "sliding distance in one passage", [](const RowWear& r) { return r.sliding; }},
};

double deepest(const DepthOverS& body) {
  return body.depth.empty() ? 0 : std::ranges::max(body.depth);
}

} // namespace

WearRates rates_of(const SceneResult& result, const Wear& wear, double axle_force) {
  if (!(result.motion.rolling.radius > 0))
    throw InputError("There is no wear by kilometre of a patch", "it has no wheel, whose radius would count",
                     "Give a scene of a wheel on a rail.");
  if (result.motion.slope_force)
    refuse_uneven("There is no wear by kilometre of an uneven wheel or rail",
                  "the contact is another at each place");
  const double turn = 2 * std::numbers::pi * result.motion.rolling.radius_at(result.motion.xi); // mm
  const double mass = axle_force / (standard_gravity / 1000) / tonne; // t: m/s^2 of mm/s^2
  const double depth = deepest(wear.rail), area = wear.rail.area(), by_mgt = million / mass;
  return {.t_gamma = quantity("T_gamma").value(result),
          .wheel_depth = depth * kilometre / turn,
          .wheel_area = area * kilometre / turn,
          .rail_depth = depth * million,
          .rail_area = area * million,
          .axle_load = mass,
          .mgt_rail_depth = depth * by_mgt,
          .mgt_rail_area = area * by_mgt};
}

std::span<const ColumnOf<WearRates>> rate_columns() {
  return columns;
}

record::Table rows_of(const WearRates& rates, const Wear& wear) {
  const double deep = deepest(wear.rail), turns = deep > 0 ? rates.wheel_depth / deep : 0; // by km
  std::vector<RowWear> rows;
  for (std::size_t i = 0; i < wear.rail.s.size(); ++i)
    rows.push_back({wear.rail.s[i], wear.wheel.s.empty() ? std::nan("") : wear.wheel.s[i],
                    million * wear.rail.depth[i], turns * wear.rail.depth[i], wear.sliding_over_s[i]});
  return record::table_of("row of elements", row_columns, rows);
}

record::Record record_of(const WearRates& rates, const Wear& wear) {
  record::Record out = record::numbers_of(rate_columns(), false, rates);
  out.add("rows", rows_of(rates, wear));
  return out;
}

} // namespace bem_contact::wear
