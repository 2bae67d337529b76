#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/csv_name.hpp"
#include "bem_contact/app/output/datasets.hpp"
#include "bem_contact/app/output/error_text.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/scene_record.hpp"
#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/influence/file_kinds.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::app {

namespace {

using nlohmann::json;

constexpr const char* fatigue_help =
    R"(Every case of the table [sweep] is solved. Each patch gets one line: its point in the shakedown diagram (p0/k and mu
used), FI_surf of the patch and of its worst element, T-gamma, and the damage of one passage. Each case has the largest von
Mises and Tresca stress below the surface with its depth. Example:
    bem_contact fatigue data/scenes/wear_collective.toml --csv fatigue.csv
You should see how many patches lie beyond the limit of the surface. Your own steel: --nodes 20 65 175 --damage 0 1e-5 0.

More, and how to draw it: data/tutorial/fatigue.md.)";

struct FatigueArguments {
  std::string scene, csv, output;
  bool json = false;
  fatigue::FatigueProperties properties;
};

/// One number of each patch of each case.
struct Column {
  const char *name, *unit, *description;
  std::vector<double> values = {};
};

/// What all outputs are made of.
struct FatigueTable {
  std::vector<Column> columns;
  std::size_t cases = 0, beyond = 0; ///< patches beyond the limit of the surface
  double damage = 0;                 ///< of one passage, mean over the collective, 1

  std::size_t patches() const { return columns.front().values.size(); }
};

FatigueTable empty_table() {
  FatigueTable out{.columns = {{"case", "1", "of the sweep, from 0"},
                               {"patch", "1", "of the case, from 0, the largest force first"},
                               {"weight", "1", "how often the case occurs"}}};
  for (const fatigue::PatchColumn& c : fatigue::patch_columns())
    out.columns.push_back({c.name, c.unit, c.description});
  for (Column c : {Column{"von_mises", "MPa", "largest below the surface of the case"},
                   {"von_mises_depth", "mm", "where that is"},
                   {"tresca", "MPa", "largest shear stress below the surface of the case"},
                   {"tresca_depth", "mm", "where that is"}})
    out.columns.push_back(std::move(c));
  return out;
}

/// A row for each patch.
void add_case(FatigueTable& table, std::size_t index, double weight, const fatigue::Fatigue& f) {
  const fatigue::StressPeaks peaks = f.peaks.value_or(fatigue::StressPeaks{});
  for (std::size_t k = 0; k < f.patches.size(); ++k) {
    std::vector<double> row{double(index), double(k), weight};
    for (const fatigue::PatchColumn& column : fatigue::patch_columns())
      row.push_back(column.value(f.patches[k]));
    for (const fatigue::StressPeak& peak : {peaks.von_mises, peaks.tresca})
      row.insert(row.end(), {peak.stress, peak.depth});
    for (std::size_t c = 0; c < row.size(); ++c)
      table.columns[c].values.push_back(row[c]);
    table.beyond += f.patches[k].surface_index > 0;
  }
}

FatigueTable solve_all(const SweepFile& sweep, fatigue::FatigueProperties properties) {
  FatigueTable table = empty_table();
  Sequence sequence({.displacements = false});
  double weights = 0;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SceneFile scene = sweep.scene(i);
    const SceneResult result = sequence.solve(scene);
    if (!result.result.converged)
      throw ConvergenceError(fmt::format("Case {} has no certified result", i), sweep.describe(i),
                             "Solve it alone to see why.");
    properties.poisson = scene.rail.material.poisson;
    const fatigue::Fatigue f = fatigue_of(result, properties);
    add_case(table, i, sweep.weight(i), f);
    for (const fatigue::PatchFatigue& patch : f.patches)
      table.damage += sweep.weight(i) * patch.damage;
    weights += sweep.weight(i);
  }
  table.cases = sweep.size();
  table.damage /= weights;
  return table;
}

std::string csv_of(const FatigueTable& table) {
  std::string out;
  for (const Column& c : table.columns)
    out += (out.empty() ? "" : ",") + csv_name(c.name, c.unit);
  out += '\n';
  for (std::size_t row = 0; row < table.patches(); ++row) {
    for (const Column& c : table.columns)
      out += fmt::format("{}{:.8g}", &c == &table.columns.front() ? "" : ",", c.values[row]);
    out += '\n';
  }
  return out;
}

/// "patches": a list for each column.
json json_of(const FatigueTable& table) {
  json out = {{"cases", table.cases}, {"beyond_surface_limit", table.beyond}, {"damage", table.damage}};
  for (const Column& c : table.columns) {
    out["patches"][c.name] = c.values;
    out["units"][c.name] = c.unit;
  }
  return out;
}

/// The group "patches" with the same names; what was asked as in result files.
H5Table h5_of(const FatigueTable& table, const FatigueArguments& arguments, const SweepFile& sweep) {
  H5Table out = file_of(fatigue_format, given_sweep(sweep, ""), arguments.output);
  for (const Column& c : table.columns)
    out.datasets[std::string("patches/") + c.name] = line(c.values, c.unit, c.description);
  out.datasets["damage"] = single(table.damage, "1", "of one passage, mean over the collective");
  out.attributes["yield_shear_MPa"] = arguments.properties.yield_shear;
  return out;
}

ExitCode run(const FatigueArguments& arguments) {
  const SweepFile sweep = read_sweep_file(arguments.scene);
  check_values(sweep);
  validate(arguments.properties.damage);
  require_named_outputs(files_read(arguments.scene, sweep),
                        {{"--output", arguments.output, OutputForm::whole_file}, {"--csv", arguments.csv}});
  const FatigueTable table = solve_all(sweep, arguments.properties);
  if (!arguments.output.empty())
    write_h5(arguments.output, h5_of(table, arguments, sweep));
  if (!arguments.csv.empty())
    write_text(arguments.csv, [&](std::ostream& out) { out << csv_of(table); });
  if (arguments.json) {
    fmt::print("{}\n", json_of(table).dump(2));
    return success;
  }
  if (arguments.csv.empty() && arguments.output.empty())
    fmt::print("{}", csv_of(table));
  fmt::print("{}, {}, {} of them beyond the limit of the surface (FI_surf > 0)\n",
             counted(static_cast<int>(table.cases), "case", "cases"),
             counted(static_cast<int>(table.patches()), "patch", "patches"), table.beyond);
  fmt::print("damage of one passage, mean over the collective: {:.4g}\n", table.damage);
  return success;
}

} // namespace

Command add_fatigue(CLI::App& program) {
  const auto arguments = std::make_shared<FatigueArguments>();
  FatigueArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("fatigue", "Rolling contact fatigue of each case of a sweep");
  line->add_option("scene", a.scene, "Scene file (TOML) with a table [sweep]")->required();
  add_json(*line, a.json);
  line->add_option("--csv", a.csv, "Write one line for each patch to this file");
  line->add_option("-o,--output", a.output, "Write the same with units and the scene (HDF5)");
  line->add_option("--yield-shear", a.properties.yield_shear, "k, the yield stress in shear, MPa")
      ->check(CLI::Range(1.0, 1e4))
      ->capture_default_str();
  line->add_option("--nodes", a.properties.damage.t_gamma, "T-gamma of the damage function, N, rising");
  line->add_option("--damage", a.properties.damage.damage, "Damage of one passage at each of these");
  line->add_flag("--wear-is-negative", a.properties.damage.wear_is_negative,
                 "Above the last node the damage goes on below zero");
  line->footer(fatigue_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
