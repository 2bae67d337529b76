#include "bem_contact/app/result_file.hpp"
#include "bem_contact/contact/history.hpp"

#include "bem_contact/app/report.hpp"
#include "bem_contact/app/stresses_output.hpp"
#include "bem_contact/app/structure_output.hpp"
#include "bem_contact/sequence/printed_errors.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::app {

namespace {

H5Dataset field(const ContactGrid& grid, std::vector<double> values, std::string unit,
                std::string description) {
  values.resize(grid.size(), 0.0); // a frictionless result has no slip
  return {{static_cast<std::size_t>(grid.ms), static_cast<std::size_t>(grid.mx)},
          std::move(values),
          std::move(unit),
          std::move(description)};
}

H5Dataset line(std::vector<double> values, std::string unit, std::string description) {
  const std::size_t n = values.size();
  return {{n}, std::move(values), std::move(unit), std::move(description)};
}

H5Dataset points(const std::vector<Point2>& line, std::string description) {
  H5Dataset out{{line.size(), 2}, {}, "mm", std::move(description)};
  for (const Point2& p : line)
    out.values.insert(out.values.end(), {p.y, p.z});
  return out;
}

/// [step][ms][mx] of every step, and the totals [step].
void add_history(H5Table& table, const std::string& group, const SceneResult& r) {
  const ContactGrid& grid = r.problem.grid;
  const auto fields = [&](const char* name, std::vector<double> ContactResult::*member, const char* unit) {
    H5Dataset out{{r.history.size(), static_cast<std::size_t>(grid.ms), static_cast<std::size_t>(grid.mx)},
                  {},
                  unit,
                  "of every step"};
    for (const ContactResult& step : r.history)
      out.values.insert(out.values.end(), (step.*member).begin(), (step.*member).end());
    table.datasets[group + name] = std::move(out);
  };
  const auto totals = [&](const char* name, double ContactResult::*member, const char* unit) {
    std::vector<double> values;
    for (const ContactResult& step : r.history)
      values.push_back(step.*member);
    table.datasets[group + name] = line(std::move(values), unit, "of every step");
  };
  fields("p_x", &ContactResult::px, "MPa");
  fields("p_s", &ContactResult::ps, "MPa");
  fields("p_n", &ContactResult::pn, "MPa");
  const bool shift = r.problem.motion == MotionKind::shift;
  fields("slip_x", &ContactResult::slip_x, shift ? "mm" : "1");
  fields("slip_s", &ContactResult::slip_s, shift ? "mm" : "1");
  totals("Fx", &ContactResult::Fx, "N");
  totals("Fy", &ContactResult::Fy, "N");
  totals("Fz", &ContactResult::Fz, "N");
  totals("Fs", &ContactResult::Fs, "N");
  totals("approach", &ContactResult::approach, "mm");
  totals("creepage_x", &ContactResult::creepage_x, shift ? "mm" : "1");
  totals("creepage_s", &ContactResult::creepage_s, shift ? "mm" : "1");
}

/// One line [patch] for each number of the patches, and for its error (nan: none can be given).
void add_patches(H5Table& table, const std::string& group, const SceneResult& r) {
  for (const PrintedPatchNumber& number : printed_patch_numbers()) {
    std::vector<double> values, errors;
    for (std::size_t i = 0; i < r.result.patches.size(); ++i) {
      values.push_back(r.result.patches[i].*number.value);
      errors.push_back(errors_of_patch(r.result, i).*number.error);
    }
    if (values.empty())
      return;
    table.datasets[group + number.name] = line(std::move(values), number.unit, "of each patch");
    if (std::ranges::none_of(errors,
                             [](double error) { return std::isnan(error); })) // of all patches, or of none
      table.datasets[group + number.error_name] =
          line(std::move(errors), number.unit, "estimated error by the size of the elements");
  }
}

/// Fields and totals in `group` ("" or a path with its last slash).
void add_result(H5Table& table, const std::string& group, const SceneResult& r) {
  const ContactGrid& grid = r.problem.grid;
  const ContactResult& c = r.result;
  table.datasets[group + "p_x"] = field(grid, c.px, "MPa", "traction on the rail along x");
  table.datasets[group + "p_s"] = field(grid, c.ps, "MPa", "traction on the rail along s");
  table.datasets[group + "p_n"] = field(grid, c.pn, "MPa", "pressure");
  const bool shift = r.problem.motion == MotionKind::shift;
  const std::string per = shift ? " in the step" : " per unit of rolled distance";
  table.datasets[group + "slip_x"] = field(grid, c.slip_x, shift ? "mm" : "1", "slip along x" + per);
  table.datasets[group + "slip_s"] = field(grid, c.slip_s, shift ? "mm" : "1", "slip along s" + per);
  table.datasets[group + "deformed_distance"] = field(grid, c.deformed_distance, "mm", "deformed distance");
  const Displacements& u = c.displacements;
  const std::string what = "displacement difference, wheel less rail, along ";
  table.datasets[group + "u_x"] = field(grid, u.ux, "mm", what + "x");
  table.datasets[group + "u_s"] = field(grid, u.us, "mm", what + "s");
  table.datasets[group + "u_n"] = field(grid, u.un, "mm", what + "n");
  table.datasets[group + "friction_power"] =
      field(grid, friction_power(c), shift ? "N/mm" : "MPa", "dissipated" + per);
  if (!r.history.empty())
    add_history(table, group + "history/", r);
  std::vector<double> state(c.state.size());
  std::ranges::transform(c.state, state.begin(), [](ElementState e) { return double(e); });
  table.datasets[group + "state"] = field(grid, state, "1", "0 exterior, 1 adhesion, 2 slip");

  if (r.stresses)
    add_stresses(table, group + "stresses/", *r.stresses);

  if (r.structure)
    add_structure(table, group + "structure/", *r.structure);

  auto& a = table.attributes;
  a[group + "approach_datum"] = r.approach_datum;
  a[group + "model"] = std::string(name_of(r.model));
  a[group + "reason"] = r.reason;
  a[group + "Fx_N"] = c.Fx;
  a[group + "Fy_N"] = c.Fy;
  a[group + "Fz_N"] = c.Fz;
  a[group + "Mz_Nmm"] = r.moment;
  a[group + "Fs_N"] = c.Fs;
  a[group + "friction_power"] = friction_power(r.result, r.problem.element_area());
  a[group + "creepage_found_x"] = c.creepage_x;
  a[group + "creepage_found_s"] = c.creepage_s;
  if (r.lateral)
    a[group + "lateral_mm"] = *r.lateral;
  a[group + "xi"] = r.xi;
  if (r.free_rolling) {
    a[group + "free_rolling_xi"] = r.free_rolling->xi;
    a[group + "free_rolling_radius_mm"] = r.free_rolling->rolling_radius;
  }
  a[group + "approach_mm"] = c.approach;
  a[group + "pmax_MPa"] = largest_pressure(r.result);
  a[group + "area_mm2"] = contact_area(r.result);
  a[group + "patches"] = double(c.patches.size());
  for (const PrintedNumber& number : printed_numbers())
    if (const double error = number.error(r); !std::isnan(error)) // an error that is not known is left out
      a[group + number.error_name] = error;
  a[group + "adhesion_share"] = adhesion_share(c);
  a[group + "converges_with_elements"] = c.discretisation && c.discretisation->converges ? 1.0 : 0.0;
  add_patches(table, group + "patch/", r);
  a[group + "certificate_worst"] = c.certificate.worst();
  a[group + "certificate_tolerance"] = c.certificate.tolerance;
  a[group + "certificate_holds"] = c.certificate.holds() ? 1.0 : 0.0;
  a[group + "seconds"] = r.seconds.numbers + r.seconds.solve;
}

/// Where the elements lie, and the bodies around them.
void add_coordinates(H5Table& table, const std::string& group, const SceneResult& r) {
  const ContactProblem& problem = r.problem;
  const std::string side = r.left ? "left" : "right";
  std::vector<double> s, y, z, delta;
  for (const ContactRow& row : problem.rows) {
    s.push_back(row.s);
    y.push_back(row.position.y);
    z.push_back(row.position.z);
    delta.push_back(row.delta);
  }
  auto& d = table.datasets;
  d[group + "x"] = line(problem.grid.columns(), "mm", "middle of the columns, rolling direction");
  d[group + "s"] = line(s, "mm", "middle of the rows, arc length along the rail");
  d[group + "y"] = line(y, "mm", "middle of the rows, to the " + side + " (track frame)");
  d[group + "z"] = line(z, "mm", "middle of the rows, down (track frame)");
  d[group + "delta"] = line(delta, "rad", "inclination of the rows");
  if (!r.wheel_s.empty())
    d[group + "wheel_s"] = line(r.wheel_s, "mm", "arc length along the wheel opposite the rows");
  d[group + "gap"] = field(problem.grid, problem.gap, "mm", "undeformed distance along the rail's normal");
  d[group + "rail_profile"] = points(r.rail_profile, "rail near the contact: y, z");
  d[group + "wheel_profile"] = points(r.wheel_profile, "wheel near the contact at approach 0: y, z");
  auto& a = table.attributes;
  a[group + "frame"] = "x rolling direction, y " + side + ", z down; s along the rail, n into the rail";
  a[group + "dx_mm"] = problem.grid.dx;
  a[group + "ds_mm"] = problem.grid.ds;
  a[group + "friction"] = problem.tangential ? problem.largest_friction() : 0.0;
  a[group + "reference_s_mm"] = r.reference.s;
  a[group + "reference_y_mm"] = r.reference.position.y;
  a[group + "reference_z_mm"] = r.reference.position.z;
  a[group + "reference_delta_rad"] = r.reference.delta;
}

H5Table table_of(const std::string& scene) {
  H5Table table;
  table.attributes["format"] = std::string(result_format);
  table.attributes["scene"] = scene;
  return table;
}

} // namespace

H5Table to_table(const SceneResult& result, const std::string& scene) {
  H5Table table = table_of(scene);
  add_coordinates(table, "", result);
  add_result(table, std::string(name_of(result.model)) + "/", result);
  return table;
}

H5Table to_table(const Comparison& comparison, const std::string& scene) {
  H5Table table = table_of(scene);
  const auto add = [&](const std::string& set, const std::vector<SceneResult>& results) {
    for (const SceneResult& result : results) {
      const std::string group = set + std::string(name_of(result.model)) + "/";
      add_coordinates(table, group, result);
      add_result(table, group, result);
    }
  };
  add("equal_forces/", comparison.at_forces);
  add("equal_position/", comparison.at_position);
  return table;
}

} // namespace bem_contact::app
