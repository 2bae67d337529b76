#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/record/csv.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/sequence/scene_record.hpp"
#include "bem_contact/task/engine.hpp"
#include "bem_contact/uses/fatigue/fatigue_of_result.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* fatigue_help =
    R"(Every case of the table [sweep] is solved (without one: the scene). Each patch gets one line: its point in the shakedown diagram (p0/k and mu
used), FI_surf of the patch and of its worst element, T-gamma, and the damage of one passage. Each case has the largest von
Mises and Tresca stress below the surface with its depth. Example:
    bem_contact fatigue data/scenes/wear_collective.toml --csv fatigue.csv
You should see how many patches lie beyond the shakedown limits of the surface and below it. Your own steel: --nodes 20 65 175 --damage 0 1e-5 0.

More, and how to draw it: data/tutorial/fatigue.md.)";

struct FatigueArguments {
  std::string scene, csv, output, body;
  bool json = false;
  fatigue::FatigueProperties properties;
};

std::string summary_of(const fatigue::CollectiveFatigue& table) {
  return fmt::format(
      "{}, {}: {} beyond the shakedown limit of the surface (FI_surf > 0), {} beyond that below the "
      "surface alone\ndamage of one passage, mean over the collective: {:.4g}\n",
      counted(table.cases, "case", "cases"), counted(table.patches.size(), "patch", "patches"),
      table.beyond_surface, table.beyond_below, table.damage);
}

ExitCode run(const FatigueArguments& arguments) {
  const SceneText text = read_scene_text(arguments.scene);
  const SweepFile sweep = has_sweep(text) ? parse_sweep_file(text) : SweepFile{text}; // one case
  check_values(sweep);
  std::vector<std::filesystem::path> inputs = files_read(arguments.scene, sweep);
  inputs.push_back(arguments.body);
  require_named_outputs(inputs,
                        {{"--output", arguments.output, OutputForm::whole_file}, {"--csv", arguments.csv}});
  fatigue::FatigueProperties properties = arguments.properties;
  properties.body = arguments.body;
  const int threads = static_cast<int>(task::processes_of(0));
  const fatigue::CollectiveFatigue table = fatigue_of(sweep, properties, nullptr, threads);
  const auto write = [&](std::ostream& out) {
    record::write_csv(
        out, record::table_of("patch", fatigue::collective_columns(!properties.body.empty()), table.patches),
        8);
  };
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output, headed(fatigue_format, given_sweep(sweep, ""), arguments.output)
                                             .append(record_of(table, properties)));
  if (!arguments.csv.empty())
    write_text(arguments.csv, write);
  if (!arguments.json && arguments.csv.empty() && arguments.output.empty())
    write(std::cout);
  print_answer(headed(fatigue_format).append(record_of(table, properties)), arguments.json,
               summary_of(table));
  return success;
}

} // namespace

Command add_fatigue(CLI::App& program) {
  const auto arguments = std::make_shared<FatigueArguments>();
  FatigueArguments& a = *arguments;
  CLI::App* line = program.add_subcommand("fatigue", "Rolling contact fatigue of each case of a sweep");
  line->add_option("scene", a.scene, "Scene file (TOML), perhaps with a table [sweep]")->required();
  add_json(*line, a.json);
  add_output_option(*line, "--csv", a.csv, "Write one line for each patch to this file");
  add_output_option(*line, "-o,--output", a.output, "Write the same with units and the scene (HDF5)");
  line->add_option("--yield-shear", a.properties.yield_shear, "k, the yield stress in shear, MPa")
      ->check(CLI::Range(1.0, 1e4))
      ->capture_default_str();
  line->add_option("--nodes", a.properties.damage.t_gamma, "T-gamma of the damage function, N, rising");
  line->add_option("--damage", a.properties.damage.damage, "Damage of one passage at each of these");
  line->add_flag("--wear-is-negative", a.properties.damage.wear_is_negative,
                 "Above the last node the damage goes on below zero");
  line->add_option(
          "--body", a.body,
          "Influence file (HDF5) with stresses, or body file (TOML, by mesh_body and fem_influence), "
          "of the rail or the wheel: stresses and shakedown limit below the surface are those in it")
      ->type_name(file_option);
  line->footer(fatigue_help);
  return {line, [arguments] { return run(*arguments); }};
}

} // namespace bem_contact::app
