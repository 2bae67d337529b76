#include "bem_contact/app/output/result_file.hpp"
#include "bem_contact/contact/history.hpp"

#include "bem_contact/app/output/asked_output.hpp"
#include "bem_contact/influence/file_kinds.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <cmath>
#include <fmt/format.h>

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
  fields("p_x", &ContactResult::px, "MPa");
  fields("p_s", &ContactResult::ps, "MPa");
  fields("p_n", &ContactResult::pn, "MPa");
  const bool shift = r.problem.motion == MotionKind::shift;
  fields("slip_x", &ContactResult::slip_x, shift ? "mm" : "1");
  fields("slip_s", &ContactResult::slip_s, shift ? "mm" : "1");
  for (const StepQuantity& q : step_quantities())
    table.datasets[group + q.name] = H5Dataset::line(q.values(r), q.unit.of(r), q.description);
}

/// One line [patch] for each number of the patches, and for its error.
void add_patches(H5Table& table, const std::string& group, const SceneResult& r) {
  const std::size_t count = r.result.patches.size();
  if (count > 0)
    with_errors(patch_quantities(),
                [&](const std::string& name, const QuantityUnit& unit, auto value, const char* description) {
                  std::vector<double> values;
                  for (std::size_t i = 0; i < count; ++i)
                    values.push_back(value(r, i));
                  table.datasets[group + name] = H5Dataset::line(std::move(values), unit.of(r), description);
                });
}

void add_quantities(H5Table& table, const std::string& group, const SceneResult& r) {
  with_errors(quantities(),
              [&](const std::string& name, const QuantityUnit& unit, auto value, const char* description) {
                table.datasets[group + name] = H5Dataset::single(value(r), unit.of(r), description);
              });
}

/// How the solver went and whether its result can be trusted.
void add_trust(H5Table& table, const std::string& group, const SceneResult& r) {
  const ContactResult& c = r.result;
  auto& a = table.attributes;
  a[group + "approach_datum"] = r.approach_datum;
  a[group + "model"] = std::string(name_of(r.model));
  a[group + "reason"] = r.reason;
  a[group + "why_no_errors"] = why_no_errors(r);
  a[group + "converges_with_elements"] = c.discretisation && c.discretisation->converges ? 1.0 : 0.0;
  a[group + "certificate_worst"] = c.certificate.worst();
  a[group + "certificate_tolerance"] = c.certificate.tolerance;
  a[group + "certificate_holds"] = c.certificate.holds() ? 1.0 : 0.0;
  a[group + "normal_solver"] = c.normal_solver;
  a[group + "tangential_solver"] = c.tangential_solver;
  a[group + "remark"] = c.remark;
  a[group + "seconds"] = r.seconds.total;
  std::string warnings;
  for (const std::string& warning : r.warnings)
    warnings += warning + "\n";
  table.texts[group + "warnings"] = {warnings, "one line for each"};
}

/// Fields and numbers in `group` ("" or a path with its last slash).
void add_result(H5Table& table, const std::string& group, const SceneResult& r, bool with_quantities = true) {
  for (const ElementQuantity& q : element_quantities())
    if (q.is_in(r) && std::string_view(q.name) != "gap") // a coordinate
      table.datasets[group + q.name] = field(r.problem.grid, q.values(r), q.unit.of(r), q.description);
  if (!r.history.empty())
    add_history(table, group + "history/", r);
  if (r.stresses)
    add_stresses(table, group + "stresses/", *r.stresses);
  if (r.structure)
    add_structure(table, group + "structure/", *r.structure);
  if (with_quantities)
    add_quantities(table, group + "quantities/", r);
  add_patches(table, group + "patches/", r);
  add_trust(table, group, r);
}

/// Where the elements lie, and the bodies around them.
void add_coordinates(H5Table& table, const std::string& group, const SceneResult& r) {
  const ContactProblem& problem = r.problem;
  const std::string side = r.left ? "left" : "right";
  auto& d = table.datasets;
  d[group + "x"] = H5Dataset::line(problem.grid.columns(), "mm", "middle of the columns, rolling direction");
  for (const RowQuantity& q : row_quantities()) {
    std::vector<double> values = q.values(r);
    if (!std::isnan(values.front()))
      d[group + q.name] = H5Dataset::line(std::move(values), q.unit.of(r), q.description);
  }
  d[group + "gap"] = field(problem.grid, problem.gap, "mm", "undeformed distance along the rail's normal");
  d[group + "rail_profile"] = H5Dataset::points(r.rail_profile, "rail, fine near the contact: y, z");
  d[group + "wheel_profile"] =
      H5Dataset::points(r.wheel_profile, "wheel at approach 0, fine near the contact: y, z");
  auto& a = table.attributes;
  a[group + "frame"] = "x rolling direction, y " + side + ", z down; s along the rail, n into the rail";
  a[group + "dx_mm"] = problem.grid.dx;
  a[group + "ds_mm"] = problem.grid.ds;
  a[group + "friction"] = problem.tangential ? problem.largest_friction() : 0.0;
}

void add_geometry(H5Table& table, const SceneResult& r) {
  const auto add = [&](const char* key, std::uint64_t digest) {
    if (digest != 0)
      table.attributes[std::string("inputs/") + key + "/geometry"] = fmt::format("{:016x}", digest);
  };
  add("rail.profile", r.rail_geometry);
  add("wheel.profile", r.wheel_geometry);
}

/// Fx of every model [creepage], and its error; nothing where the comparison has none.
void add_creep_forces(H5Table& table, const Comparison& c) {
  if (c.creep_forces.empty())
    return;
  auto& d = table.datasets;
  d["creep_forces/xi_from_free_rolling"] = H5Dataset::line(
      c.creep_forces.creepage, "1",
      "longitudinal creepage beyond free rolling; each model has its own creepage of free rolling");
  for (std::size_t m = 0; m < c.models.size(); ++m) {
    const std::string model(name_of(c.models[m]));
    d["creep_forces/Fx/" + model] = H5Dataset::line(
        c.creep_forces.Fx[m], "N", "longitudinal force on the rail, at the place of equal_forces");
    d["creep_forces/Fx_error/" + model] = H5Dataset::line(c.creep_forces.Fx_error[m], "N", error_description);
  }
}

} // namespace

H5Table to_table(const SceneResult& result, const GivenScene& given, const std::filesystem::path& output) {
  H5Table table = file_of(result_format, given, output);
  add_geometry(table, result);
  add_coordinates(table, "", result);
  add_result(table, std::string(name_of(result.model)) + "/", result);
  return table;
}

void add_whole_result(H5Table& table, const std::string& group, const SceneResult& result) {
  add_coordinates(table, group, result);
  add_result(table, group, result);
}

H5Table to_case_table(const SceneResult& result) {
  H5Table table;
  table.attributes["format"] = std::string(case_format);
  add_coordinates(table, "", result);
  add_result(table, std::string(name_of(result.model)) + "/", result, false);
  return table;
}

H5Table to_table(const Comparison& comparison, const GivenScene& given, const std::filesystem::path& output) {
  H5Table table = file_of(comparison_format, given, output);
  add_geometry(table, comparison.leading().front());
  const auto add = [&](const std::string& set, const std::vector<SceneResult>& results) {
    for (const SceneResult& result : results)
      add_whole_result(table, set + std::string(name_of(result.model)) + "/", result);
  };
  add("equal_forces/", comparison.at_forces);
  add("equal_position/", comparison.at_position);
  add_creep_forces(table, comparison);
  return table;
}

} // namespace bem_contact::app
