#include "bem_contact/app/creep_curves_output.hpp"

#include "bem_contact/app/csv_name.hpp"
#include "bem_contact/app/datasets.hpp"
#include "bem_contact/app/file_kinds.hpp"
#include "bem_contact/curves/creep_columns.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

using nlohmann::json;

/// The derivatives that linear theory does not set to zero: [force][creepage].
constexpr std::pair<std::size_t, std::size_t> in_linear_theory[] = {{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}};

std::string slopes_text(const CreepCurves& c) {
  std::string out =
      "Slopes where nothing moves over the other (no creepage, no spin), beside Kalker's linear theory\n";
  if (c.linear)
    out += fmt::format(
        "  for the ellipse of {:.4g} x {:.4g} mm (semi-axes along x, s), from which the undeformed distance "
        "is {:.1f} % off\n",
        c.linear->semi_axis_x, c.linear->semi_axis_s, 100 * c.linear->deviation);
  else
    out += "  (the contact is no ellipse: nothing to compare with)\n";
  out += "               computed        +-      Kalker   difference\n";
  for (const auto& [f, k] : in_linear_theory) {
    const double value = c.slopes.values[f][k];
    const std::string what =
        fmt::format("d{}/d{}", EnumNames<CreepForce>::names[f], EnumNames<CreepKind>::names[k]);
    out += fmt::format("  {:9} {:12.5g} {:9.1g}", what, value, c.slopes.errors[f][k]);
    if (c.linear)
      out += fmt::format(" {:11.5g} {:10.2f} %", c.linear->slopes[f][k],
                         100 * (value / c.linear->slopes[f][k] - 1));
    out += '\n';
  }
  return out;
}

std::string sensitivities_text(const CreepCurves& c) {
  std::string out = "Sensitivities at the scene's creepages, by differences\n              force      d/dxi  "
                    "   d/deta     d/dphi\n";
  const CreepForceValues forces = forces_of(c.solution);
  for (std::size_t f = 0; f < 3; ++f) {
    out += fmt::format("  {:4} {:12.5g}", EnumNames<CreepForce>::names[f], forces[f]);
    for (std::size_t k = 0; k < 3; ++k)
      out += fmt::format(" {:10.4g}", c.sensitivities.values[f][k]);
    out += '\n';
  }
  if (c.linearised) {
    out += "  from the linear system at the solution, with the pressure held\n";
    for (std::size_t f = 0; f < 3; ++f)
      out += fmt::format("  {:4} {:12} {:10.4g} {:10.4g} {:10.4g}\n", EnumNames<CreepForce>::names[f], "",
                         (*c.linearised)[f][0], (*c.linearised)[f][1], (*c.linearised)[f][2]);
  }
  return out;
}

} // namespace

std::string to_text(const CreepCurves& c) {
  std::string out = fmt::format("Creep curves, model {}: Fz {:.6g} N, mu Fn {:.6g} N, c = {:.4g} mm\n",
                                name_of(c.solution.model), c.solution.result.Fz, c.bound, c.radius);
  out += slopes_text(c) + sensitivities_text(c);
  for (const CreepCurve& curve : c.curves) {
    out += fmt::format("Over {}\n  {:>12}        Fx N        Fs N     Mz N mm  |F|/(mu Fn)  adhesion\n",
                       name_of(curve.which), name_of(curve.which));
    for (const CreepPoint& p : curve.points)
      out +=
          fmt::format("  {:12.5g} {:11.5g} {:11.5g} {:11.5g} {:12.4f} {:8.1f} %{}\n", p.creepage, p.forces[0],
                      p.forces[1], p.forces[2], std::hypot(p.forces[0], p.forces[1]) / c.bound,
                      100 * p.adhesion_share, p.certified ? "" : "  NOT certified");
  }
  return out;
}

json to_json(const CreepCurves& c) {
  json out = {{"model", name_of(c.solution.model)},
              {"Fz", c.solution.result.Fz},
              {"bound", c.bound},
              {"radius", c.radius},
              {"certified", c.certified()},
              {"forces", forces_of(c.solution)},
              {"curves", json::object()}};
  for (const CreepMatrixEntry& entry : creep_matrices()) {
    const CreepMatrix* matrix = entry.of(c);
    out[entry.name] = matrix ? json(*matrix) : json(nullptr);
  }
  if (const auto& l = c.linear)
    out["kalker"] = {{"slopes", l->slopes},           {"semi_axis_x", l->semi_axis_x},
                     {"semi_axis_s", l->semi_axis_s}, {"tilt", l->tilt},
                     {"deviation", l->deviation},     {"shear_modulus", l->shear_modulus},
                     {"poisson", l->poisson},         {"c11", l->coefficients.c11},
                     {"c22", l->coefficients.c22},    {"c23", l->coefficients.c23},
                     {"c33", l->coefficients.c33}};
  for (const CreepCurve& curve : c.curves) {
    json& of = out["curves"][std::string(name_of(curve.which))];
    of["creepage"] = creepages_of(curve);
    for (const CreepColumn& column : creep_columns())
      of[column.name] = column.values(curve.points);
  }
  return out;
}

std::string to_csv(const CreepCurves& c) {
  std::string out = "varied,creepage";
  for (const CreepColumn& column : creep_columns())
    out += ',' + csv_name(column.name, column.unit);
  out += '\n';
  for (const CreepCurve& curve : c.curves)
    for (const CreepPoint& p : curve.points) {
      out += fmt::format("{},{:.9g}", name_of(curve.which), p.creepage);
      for (const CreepColumn& column : creep_columns()) {
        const double value = column.value(p);
        out += std::isnan(value) ? "," : fmt::format(",{:.{}g}", value, column.digits);
      }
      out += '\n';
    }
  return out;
}

H5Table to_table(const CreepCurves& c) {
  H5Table table;
  auto& d = table.datasets;
  for (const CreepMatrixEntry& entry : creep_matrices())
    if (const CreepMatrix* values = entry.of(c))
      d[entry.name] = matrix(*values, "N; Mz: N mm; by phi: times mm", entry.description);
  for (const CreepCurve& curve : c.curves) {
    const std::string group = fmt::format("{}/", name_of(curve.which));
    d[group + "creepage"] =
        line(creepages_of(curve), unit_of(curve.which), "varied; the other two as the scene has them");
    for (const CreepColumn& column : creep_columns())
      d[group + column.name] = line(column.values(curve.points), column.unit, column.description);
  }
  auto& a = table.attributes;
  a["format"] = std::string(creep_curves_format);
  a["model"] = std::string(name_of(c.solution.model));
  a["Fz_N"] = c.solution.result.Fz;
  a["bound_N"] = c.bound;
  a["radius_mm"] = c.radius;
  return table;
}

} // namespace bem_contact::app
