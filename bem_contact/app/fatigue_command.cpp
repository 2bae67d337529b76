#include "bem_contact/app/command.hpp"
#include "bem_contact/app/csv_name.hpp"
#include "bem_contact/app/error_text.hpp"
#include "bem_contact/app/sweep_inputs.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/fatigue/fatigue_of_result.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <memory>
#include <ostream>
#include <string>

namespace bem_contact::app {

namespace {

constexpr const char* fatigue_help =
    R"(Every case of the table [sweep] is solved. Each patch gets one line: its point in the shakedown diagram (p0/k and mu
used), FI_surf of the patch and of its worst element, T-gamma, and the damage of one passage. Each case has the largest von
Mises and Tresca stress below the surface with its depth. Example:
    bem_contact fatigue data/scenes/wear_collective.toml --csv fatigue.csv
You should see how many patches lie beyond the limit of the surface. Your own steel: --nodes 20 65 175 --damage 0 1e-5 0.

More, and how to draw it: data/tutorial/fatigue.md.)";

struct FatigueArguments {
  std::string scene, csv;
  fatigue::FatigueProperties properties;
};

std::string head_line() {
  std::string out = "case,patch,weight";
  for (const fatigue::PatchColumn& column : fatigue::patch_columns())
    out += ',' + csv_name(column.name, column.unit);
  return out + ",von_mises_MPa,von_mises_depth_mm,tresca_MPa,tresca_depth_mm\n";
}

std::string lines_of(std::size_t index, double weight, const fatigue::Fatigue& f) {
  std::string out;
  const fatigue::StressPeaks peaks = f.peaks.value_or(fatigue::StressPeaks{});
  for (std::size_t k = 0; k < f.patches.size(); ++k) {
    out += fmt::format("{},{},{:g}", index, k, weight);
    for (const fatigue::PatchColumn& column : fatigue::patch_columns())
      out += fmt::format(",{:.8g}", column.value(f.patches[k]));
    for (const fatigue::StressPeak& peak : {peaks.von_mises, peaks.tresca})
      out += fmt::format(",{:.6g},{:.4g}", peak.stress, peak.depth);
    out += '\n';
  }
  return out;
}

ExitCode run(FatigueArguments arguments) {
  const SweepFile sweep = read_sweep_file(arguments.scene);
  check_values(sweep);
  validate(arguments.properties.damage);
  require_outputs(files_read(arguments.scene, sweep), {{"--csv", arguments.csv}});
  Sequence sequence({.displacements = false});
  std::string table = head_line();
  int beyond = 0, patches = 0;
  double damage = 0, weights = 0;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    const SceneFile scene = sweep.scene(i);
    const SceneResult result = sequence.solve(scene);
    if (!result.result.converged)
      throw ConvergenceError(fmt::format("Case {} has no certified result", i), sweep.describe(i),
                             "Solve it alone to see why.");
    arguments.properties.poisson = scene.rail.material.poisson;
    const fatigue::Fatigue f = fatigue_of(result, arguments.properties);
    const double weight = sweep.weight(i);
    weights += weight;
    for (const fatigue::PatchFatigue& patch : f.patches) {
      ++patches;
      beyond += patch.surface_index > 0;
      damage += weight * patch.damage;
    }
    table += lines_of(i, weight, f);
  }
  if (arguments.csv.empty())
    fmt::print("{}", table);
  else
    write_text(arguments.csv, [&](std::ostream& out) { out << table; });
  fmt::print("{}, {}, {} of them beyond the limit of the surface (FI_surf > 0)\n",
             counted(static_cast<int>(sweep.size()), "case", "cases"), counted(patches, "patch", "patches"),
             beyond);
  fmt::print("damage of one passage, mean over the collective: {:.4g}\n", damage / weights);
  return success;
}

} // namespace

Command add_fatigue(CLI::App& program) {
  const auto arguments = std::make_shared<FatigueArguments>();
  FatigueArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("fatigue", "Rolling contact fatigue of each case of a sweep");
  line->add_option("scene", a.scene, "Scene file (TOML) with a table [sweep]")->required();
  line->add_option("--csv", a.csv, "Write one line for each patch to this file");
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
