#include "bem_contact/app/creep_curves_output.hpp"

#include "bem_contact/base/provenance.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace bem_contact::app {

namespace {

using nlohmann::json;

constexpr const char* creepage_units[] = {"1", "1", "1/mm"};
constexpr const char* force_units[] = {"N", "N", "N mm"};
/// The derivatives that linear theory does not set to zero: [force][creepage].
constexpr std::pair<std::size_t, std::size_t> in_linear_theory[] = {{0, 0}, {1, 1}, {1, 2}, {2, 1}, {2, 2}};

std::string_view name(CreepKind kind) {
  return EnumNames<CreepKind>::names[static_cast<std::size_t>(kind)];
}

template <class Of> std::vector<double> column(const CreepCurve& curve, const Of& of) {
  std::vector<double> out;
  for (const CreepPoint& p : curve.points)
    out.push_back(of(p));
  return out;
}

/// name, unit, description, values of all columns of a curve after the creepage.
template <class Add> void each_column(const CreepCurve& curve, const Add& add) {
  for (std::size_t f = 0; f < 3; ++f) {
    const std::string force(EnumNames<CreepForce>::names[f]);
    add(force, force_units[f], "on the rail",
        column(curve, [f](const CreepPoint& p) { return p.forces[f]; }));
    add(force + "_error", force_units[f], "estimated error by the size of the elements",
        column(curve, [f](const CreepPoint& p) { return p.errors[f]; }));
  }
  add("adhesion_share", "1", "of the area in contact that adheres",
      column(curve, [](const CreepPoint& p) { return p.adhesion_share; }));
  add("certified", "1", "1: the certificate holds",
      column(curve, [](const CreepPoint& p) { return p.certified ? 1.0 : 0.0; }));
}

H5Dataset matrix(const CreepMatrix& m, const char* description) {
  H5Dataset out{{3, 3}, {}, "N; Mz: N mm; by phi: times mm", description};
  for (const auto& row : m)
    out.values.insert(out.values.end(), row.begin(), row.end());
  return out;
}

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
                       name(curve.which), name(curve.which));
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
              {"slopes", c.slopes.values},
              {"slopes_error", c.slopes.errors},
              {"sensitivities", c.sensitivities.values},
              {"sensitivities_error", c.sensitivities.errors},
              {"linearised", nullptr},
              {"kalker", nullptr},
              {"curves", json::object()}};
  if (c.linearised)
    out["linearised"] = *c.linearised;
  if (const auto& l = c.linear)
    out["kalker"] = {{"slopes", l->slopes},           {"semi_axis_x", l->semi_axis_x},
                     {"semi_axis_s", l->semi_axis_s}, {"tilt", l->tilt},
                     {"deviation", l->deviation},     {"shear_modulus", l->shear_modulus},
                     {"poisson", l->poisson},         {"c11", l->coefficients.c11},
                     {"c22", l->coefficients.c22},    {"c23", l->coefficients.c23},
                     {"c33", l->coefficients.c33}};
  for (const CreepCurve& curve : c.curves) {
    json& of = out["curves"][std::string(name(curve.which))];
    of["creepage"] = column(curve, [](const CreepPoint& p) { return p.creepage; });
    each_column(curve, [&](const std::string& what, const char*, const char*, std::vector<double> values) {
      of[what] = std::move(values);
    });
  }
  return out;
}

std::string to_csv(const CreepCurves& c) {
  std::string out =
      "varied,creepage,Fx_N,Fx_error_N,Fs_N,Fs_error_N,Mz_Nmm,Mz_error_Nmm,adhesion_share,certified\n";
  for (const CreepCurve& curve : c.curves)
    for (const CreepPoint& p : curve.points) {
      out += fmt::format("{},{:.9g}", name(curve.which), p.creepage);
      for (std::size_t f = 0; f < 3; ++f)
        out += fmt::format(",{:.9g},{}", p.forces[f],
                           std::isnan(p.errors[f]) ? "" : fmt::format("{:.3g}", p.errors[f]));
      out += fmt::format(",{:.6g},{}\n", p.adhesion_share, p.certified ? 1 : 0);
    }
  return out;
}

H5Table to_table(const CreepCurves& c, const std::string& scene) {
  H5Table table;
  auto& d = table.datasets;
  d["slopes"] = matrix(c.slopes.values, "[Fx, Fs, Mz][xi, eta, phi] where nothing moves over the other");
  d["slopes_error"] = matrix(c.slopes.errors, "by the step of the differences");
  d["sensitivities"] = matrix(c.sensitivities.values, "[Fx, Fs, Mz][xi, eta, phi] at the scene's creepages");
  d["sensitivities_error"] = matrix(c.sensitivities.errors, "by the step of the differences");
  if (c.linearised)
    d["linearised"] =
        matrix(*c.linearised, "the sensitivities from one linear system, with the pressure held");
  if (c.linear)
    d["kalker"] =
        matrix(c.linear->slopes, "[Fx, Fs, Mz][xi, eta, phi] by linear theory for the nearest ellipse");
  for (const CreepCurve& curve : c.curves) {
    const std::string group = fmt::format("{}/", name(curve.which));
    const std::size_t n = curve.points.size();
    d[group + "creepage"] = {{n},
                             column(curve, [](const CreepPoint& p) { return p.creepage; }),
                             creepage_units[static_cast<std::size_t>(curve.which)],
                             "varied; the other two as the scene has them"};
    each_column(curve, [&](const std::string& what, const char* unit, const char* description,
                           std::vector<double> values) {
      d[group + what] = {{n}, std::move(values), unit, description};
    });
  }
  auto& a = table.attributes;
  a["format"] = std::string(creep_curves_format);
  a["program"] = provenance("bem_contact");
  a["scene"] = scene;
  a["model"] = std::string(name_of(c.solution.model));
  a["Fz_N"] = c.solution.result.Fz;
  a["bound_N"] = c.bound;
  a["radius_mm"] = c.radius;
  return table;
}

} // namespace bem_contact::app
