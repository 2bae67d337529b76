#include "bem_contact/app/conicity_output.hpp"

#include "bem_contact/base/provenance.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

namespace bem_contact::app {

namespace {

using nlohmann::json;

struct FunctionColumn {
  const char *name, *unit, *description;
  double (*value)(const WheelsetStand&);
};

std::span<const FunctionColumn> function_columns() {
  using S = WheelsetStand;
  static const FunctionColumn columns[] = {
      {"lateral", "mm", "lateral displacement of the wheelset, to the right",
       [](const S& s) { return s.lateral; }},
      {"difference", "mm", "rolling radius difference, right less left",
       [](const S& s) { return s.difference(); }},
      {"roll", "rad", "roll of the wheelset, right side down", [](const S& s) { return s.roll; }},
      {"right_radius", "mm", "rolling radius of the right wheel", [](const S& s) { return s.right.radius; }},
      {"right_wheel_y", "mm", "contact on the right wheel, from the tape circle to the field side",
       [](const S& s) { return s.right.wheel.y; }},
      {"right_wheel_s", "mm", "the same, arc length", [](const S& s) { return s.right.wheel_s; }},
      {"right_rail_y", "mm", "contact on the right rail, from its origin to the field side",
       [](const S& s) { return s.right.rail.y; }},
      {"right_rail_s", "mm", "the same, arc length", [](const S& s) { return s.right.rail_s; }},
      {"right_delta", "rad", "inclination of the right contact", [](const S& s) { return s.right.delta; }},
      {"left_radius", "mm", "rolling radius of the left wheel", [](const S& s) { return s.left.radius; }},
      {"left_wheel_y", "mm", "contact on the left wheel, from the tape circle to the field side",
       [](const S& s) { return s.left.wheel.y; }},
      {"left_wheel_s", "mm", "the same, arc length", [](const S& s) { return s.left.wheel_s; }},
      {"left_rail_y", "mm", "contact on the left rail, from its origin to the field side",
       [](const S& s) { return s.left.rail.y; }},
      {"left_rail_s", "mm", "the same, arc length", [](const S& s) { return s.left.rail_s; }},
      {"left_delta", "rad", "inclination of the left contact, in the mirror image",
       [](const S& s) { return s.left.delta; }}};
  return columns;
}

struct ConicityColumn {
  const char *name, *unit, *description;
  double EquivalentConicity::*value;
};

std::span<const ConicityColumn> conicity_columns() {
  static constexpr ConicityColumn columns[] = {
      {"tan_gamma", "1", "equivalent conicity", &EquivalentConicity::tan_gamma},
      {"wavelength", "mm", "wavelength of the free lateral motion", &EquivalentConicity::wavelength},
      {"from", "mm", "its leftmost displacement", &EquivalentConicity::from},
      {"to", "mm", "its rightmost displacement", &EquivalentConicity::to}};
  return columns;
}

std::vector<double> column(const WheelsetConicity& c, const FunctionColumn& of) {
  std::vector<double> out;
  for (const WheelsetStand& s : c.stands)
    out.push_back(of.value(s));
  return out;
}

std::vector<double> column(const WheelsetConicity& c, const ConicityColumn& of) {
  std::vector<double> out;
  for (const WheelsetConicity::Value& v : c.values)
    out.push_back(v.motion ? (*v.motion).*of.value : std::numeric_limits<double>::quiet_NaN());
  return out;
}

std::vector<double> amplitudes(const WheelsetConicity& c) {
  std::vector<double> out;
  for (const WheelsetConicity::Value& v : c.values)
    out.push_back(v.amplitude);
  return out;
}

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
  for (const FunctionColumn& of : function_columns())
    out["function"][of.name] = column(c, of);
  out["conicity"]["amplitude"] = amplitudes(c);
  for (const ConicityColumn& of : conicity_columns())
    out["conicity"][of.name] = column(c, of); // nlohmann writes nan as null
  return out;
}

std::string to_csv(const WheelsetConicity& c) {
  std::string out;
  for (const FunctionColumn& of : function_columns())
    out += fmt::format("{}{}_{}", out.empty() ? "" : ",", of.name, of.unit);
  out += '\n';
  for (const WheelsetStand& s : c.stands) {
    std::string line;
    for (const FunctionColumn& of : function_columns())
      line += fmt::format("{}{:.9g}", line.empty() ? "" : ",", of.value(s));
    out += line + '\n';
  }
  return out;
}

H5Table to_table(const WheelsetConicity& c, const WheelsetOnTrack& w) {
  H5Table table;
  for (const FunctionColumn& of : function_columns())
    table.datasets[fmt::format("function/{}", of.name)] = {
        {c.stands.size()}, column(c, of), of.unit, of.description};
  table.datasets["conicity/amplitude"] = {
      {c.values.size()}, amplitudes(c), "mm", "half of the way from the leftmost to the rightmost point"};
  for (const ConicityColumn& of : conicity_columns())
    table.datasets[fmt::format("conicity/{}", of.name)] = {
        {c.values.size()}, column(c, of), of.unit, of.description};
  auto& a = table.attributes;
  a["format"] = std::string(conicity_format);
  a["program"] = provenance("bem_contact");
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
