#include "bem_contact/app/conicity_output.hpp"

#include "bem_contact/app/csv_name.hpp"
#include "bem_contact/app/datasets.hpp"
#include "bem_contact/app/file_kinds.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

using nlohmann::json;

bool is_whole(double millimetres) {
  return std::abs(millimetres - std::round(millimetres)) < 1e-9;
}

std::string head(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  std::string out = fmt::format("Wheelset: right {} on {}, left {} on {}\n", w.right_wheel.name(),
                                w.right_rail.name(), w.left_wheel.name(), w.left_rail.name());
  out += fmt::format("  wheel radius {:g} mm, contact circles {:g} mm apart, cant {:g} rad{}; {}\n",
                     c.lengths.wheel_radius, c.lengths.contact_distance, w.position.cant,
                     w.position.rail_origin ? std::string()
                                            : fmt::format(", gauge {:g} mm ({:g} mm below the top)",
                                                          w.position.gauge, w.position.gauge_height),
                     w.rolls ? "rolls until both wheels stand" : "upright");
  return out;
}

} // namespace

std::string to_text(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  std::string out = head(c, w);
  out += "Rolling radius difference and contact points, mm (y to the field side of each body)\n";
  out += "    lateral  difference   radius right   wheel y    rail y    radius left   wheel y    rail y\n";
  for (const WheelsetStand& s : c.stands)
    if (is_whole(s.lateral))
      out += fmt::format("  {:9.1f} {:11.4f} {:14.4f} {:9.2f} {:9.2f} {:14.4f} {:9.2f} {:9.2f}\n", s.lateral,
                         s.difference(), s.right.radius, s.right.wheel.y, s.right.rail.y, s.left.radius,
                         s.left.wheel.y, s.left.rail.y);
  out += "Equivalent conicity (EN 15302)\n  amplitude mm  tan gamma  wavelength m   from mm     to mm\n";
  for (const WheelsetConicity::Value& v : c.values)
    out += v.motion
               ? fmt::format("  {:12g} {:10.4f} {:13.3f} {:9.3f} {:9.3f}\n", v.amplitude, v.motion->tan_gamma,
                             1e-3 * v.motion->wavelength, v.motion->from, v.motion->to)
               : fmt::format("  {:12g} {:>10} {:>13}\n", v.amplitude, "none", "none");
  return out;
}

json to_json(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  json out = {{"right", {{"rail", w.right_rail.name()}, {"wheel", w.right_wheel.name()}}},
              {"left", {{"rail", w.left_rail.name()}, {"wheel", w.left_wheel.name()}}},
              {"wheel_radius", c.lengths.wheel_radius},
              {"contact_distance", c.lengths.contact_distance},
              {"rolls", w.rolls}};
  for (const auto& column : stand_columns())
    out["function"][column.name] = column.values(c.stands);
  for (const auto& column : conicity_columns())
    out["conicity"][column.name] = column.values(c.values); // nlohmann writes nan as null
  return out;
}

std::string to_csv(const WheelsetConicity& c) {
  std::string out;
  for (const auto& column : stand_columns())
    out += fmt::format("{}{}", out.empty() ? "" : ",", csv_name(column.name, column.unit));
  out += '\n';
  for (const WheelsetStand& s : c.stands) {
    std::string line;
    for (const auto& column : stand_columns())
      line += fmt::format("{}{:.9g}", line.empty() ? "" : ",", column.value(s));
    out += line + '\n';
  }
  return out;
}

H5Table to_table(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  H5Table table;
  const auto add = [&](const std::string& group, const auto& columns, const auto& rows) {
    for (const auto& column : columns)
      table.datasets[group + column.name] = line(column.values(rows), column.unit, column.description);
  };
  add("function/", stand_columns(), c.stands);
  add("conicity/", conicity_columns(), c.values);
  auto& a = table.attributes;
  a["format"] = std::string(conicity_format);
  a["right_rail"] = w.right_rail.name();
  a["right_wheel"] = w.right_wheel.name();
  a["left_rail"] = w.left_rail.name();
  a["left_wheel"] = w.left_wheel.name();
  a["wheel_radius_mm"] = c.lengths.wheel_radius;
  a["contact_distance_mm"] = c.lengths.contact_distance;
  a["rolls"] = w.rolls ? 1.0 : 0.0;
  return table;
}

} // namespace bem_contact::app
