#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/comparison_report.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/output/print_answer.hpp"
#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/app/output/report.hpp"
#include "bem_contact/app/output/vtk_file.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/record/json.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/sequence/quantities.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/sequence/result_warnings.hpp"
#include "bem_contact/sequence/sequence.hpp"
#include "bem_contact/sequence/settings.hpp"
#include "bem_contact/sequence/uncertified.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <spdlog/spdlog.h>

namespace bem_contact::app {

namespace {

constexpr const char* solve_help_begin =
    R"(Example: a wheel-like body rolls steadily with creepage and spin.
    bem_contact solve data/scenes/steady_rolling.toml
You should see one patch of 13.8 mm2 with a largest pressure of 437.0 MPa, and the forces on the rail: Fx 671.5 N,
Fy 919.8 N, Fz 4000.0 N. +- says how far the size of the elements may put a number off. `certificate` says `holds` if no
contact condition is violated by more than 1e-6 (relative); code that is not part of the solver checks that.

--model says where the influence numbers come from:
)";

constexpr const char* solve_help_end = R"(
A result file (-o) keeps its scene and its inputs, so that it can be solved again: `bem_contact solve result.h5`.
More, and how to draw it: data/tutorial/solve.md.

Exit code 0: the certificate holds, and a repeated result is the same. 2: the input is wrong. 3: the solver did not
converge, and nothing is written; or the certificate does not hold; or a repeated result differs. 1: an unforeseen error.)";

constexpr const char* compare_help =
    R"(fem needs influence files of both bodies. Example, with the small files of this project:
    bem_contact compare data/scenes/conformal_small.toml --models halfspace,tangent_plane,fem
You should see three tables with a column for each model:
  1. Equal forces on the rail. Fx is load.force_x, or 0: the wheel rolls freely. Fy is load.force_y, or what the
     reference (fem, or else the last model) finds at the scene's position; the other models are moved until they have it.
  2. Creep forces, each model from its own free rolling: at 0.0005, 0.001 and 0.002 beyond it.
  3. Equal position and creepage, those of the scene. Near a flange a small shift changes the forces much.
If the scene gives an approach and no force, Fz is what the reference finds for it. More: data/tutorial/compare.md.

Exit code 0: all certificates hold. 2: the input is wrong. 3: a model did not converge, or a certificate does not hold.)";

constexpr const char* check_help =
    R"(Example:
    bem_contact check data/scenes/conformal_small.toml
You should see where wheel and rail touch first (rail s = -29.957 mm, in the gauge corner), the estimated vertical
approach, the grid that would be solved (42 elements along x, 24 rows along s), and whether these rows lie on the part
of either profile that its influence file covers. Of a sweep, the first and the last case are shown; of a wheelset, both
wheels where the search for the equilibrium begins. Input that can be solved but is probably a mistake gives a warning.

Exit code 0: the scene can be solved. 2: it cannot, or --strict is set and there is a warning.)";

struct SceneArguments {
  std::string file, model, output, vtk;
  std::string folder;              ///< of a repeated result: where its scene's paths start
  std::vector<std::string> models; ///< of compare; empty: models_to_compare()
  bool json = false, strict = false;
  bool inputs = false; ///< of check: only name the files
  int threads = 1;
};

/// Success only if the result is certified().
ExitCode verdict(const SceneResult& r) {
  if (certified(r))
    return success;
  spdlog::error("{}", uncertified_error(r).what());
  return no_convergence;
}

record::Record repetition_record(const Repetition& repetition) {
  record::Record differences;
  for (const QuantityDifference& d : repetition.differences) {
    const auto number = [&](double value, const char* meaning) {
      return record::Number{value, d.quantity->unit.of(is_shift(repetition.result)), meaning};
    };
    differences.add(d.quantity->name, record::Record{{"before", number(d.before, "in the file")},
                                                     {"now", number(d.now, "of this program")},
                                                     {"allowed", number(d.allowed, "by the certificate")}});
  }
  return {{"same", repetition.same()},
          {"made_by", record::Record{{"program", record::Text{repetition.program}},
                                     {"commit", record::Text{repetition.commit}}}},
          {"differences", std::move(differences)},
          {"other_differences", record::Texts{repetition.others, "in words"}},
          {"result", record_of(repetition.result, {.fields = false})}};
}

template <class Answer> void print(const char* format, const Answer& answer, bool json) {
  print_answer(headed(format).append(record_of(answer, {.fields = false})), json, to_text(answer));
}

/// A result file in place of a scene.
ExitCode run_repeat(const SceneArguments& arguments) {
  const std::pair<const char*, const std::string*> options[] = {
      {"--model", &arguments.model}, {"--output", &arguments.output}, {"--vtk", &arguments.vtk}};
  for (const auto& [name, value] : options)
    if (!value->empty())
      throw InputError(fmt::format("{} cannot be given with the result file '{}'", name, arguments.file),
                       "its case is repeated as it was, and compared",
                       "Write its scene with bem_contact info --scene, and solve that.");
  const Repetition repetition = repeat_result(arguments.file, arguments.folder);
  warn(repetition.warnings);
  if (arguments.strict)
    refuse_warnings(repetition.result.warnings);
  print_out("{}",
            arguments.json ? record::to_json(repetition_record(repetition)) + "\n" : to_text(repetition));
  warn(repetition.result.warnings);
  return std::max(verdict(repetition.result), repetition.same() ? success : no_convergence);
}

ExitCode run_solve(const SceneArguments& arguments) {
  if (is_hdf5(arguments.file))
    return run_repeat(arguments);
  if (!arguments.folder.empty())
    throw InputError("--folder cannot be given with a scene", "a scene's paths start in its own folder",
                     "Leave it out; it is for result files.");
  const GivenScene given =
      read_given_scene_for({{"--output", arguments.output, OutputForm::whole_file}, {"--vtk", arguments.vtk}},
                           arguments.file, arguments.model);
  const SceneResult result = Sequence({.threads = arguments.threads}).solve(given.scene);
  if (arguments.strict)
    refuse_warnings(result.warnings);
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output, result_file(result, given, arguments.output));
  if (!arguments.vtk.empty())
    write_vts(arguments.vtk, result);
  print(result_format, result, arguments.json);
  warn(result.warnings);
  return verdict(result);
}

std::vector<Model> models_of(const std::vector<std::string>& names) {
  if (names.empty())
    return models_to_compare();
  std::vector<Model> models;
  for (const std::string& name : names)
    models.push_back(model_named(name).value());
  return models;
}

/// Each once, with the models and tables whose numbers it has.
Warnings warnings_of(const Comparison& comparison) {
  std::vector<PlacedWarning> all;
  const auto note = [&](const std::vector<SceneResult>& results, const char* table) {
    for (const SceneResult& result : results)
      for (const Warning& warning : result.warnings)
        all.push_back({fmt::format("{} at {}", name_of(result.choice.model), table), warning});
  };
  note(comparison.at_forces, "equal forces");
  note(comparison.at_position, "equal position");
  return once_each(all);
}

ExitCode run_compare(const SceneArguments& arguments) {
  const std::vector<Model> models = models_of(arguments.models);
  const auto surface_of = [&](Model model) {
    return fmt::format("{}_{}.vts", arguments.vtk, name_of(model));
  };
  std::vector<Output> outputs{{"--output", arguments.output, OutputForm::whole_file}};
  if (!arguments.vtk.empty())
    for (const Model model : models)
      outputs.push_back({.option = "--vtk-prefix", .file = surface_of(model), .begins_with = surface_begin});
  const GivenScene given = read_given_scene_for(outputs, arguments.file, "");
  const Comparison comparison = Sequence({.threads = arguments.threads}).compare(given.scene, models);
  if (arguments.strict)
    for (const SceneResult& result : comparison.leading())
      refuse_warnings(result.warnings);
  if (!arguments.output.empty())
    record::write_hdf5(arguments.output, comparison_file(comparison, given, arguments.output));
  if (!arguments.vtk.empty())
    for (const SceneResult& result : comparison.leading())
      write_vts(surface_of(result.choice.model), result);
  print(comparison_format, comparison, arguments.json);
  warn(warnings_of(comparison));
  if (!comparison.creep_forces.certified)
    spdlog::error(
        "Some creep forces beyond free rolling are not solutions (their certificates do not hold) Leave "
        "them out of account, or choose larger elements.");
  ExitCode worst = comparison.creep_forces.certified ? success : no_convergence;
  for (const auto* results : {&comparison.at_forces, &comparison.at_position})
    for (const SceneResult& result : *results)
      worst = std::max(worst, verdict(result));
  return worst;
}

/// Of the first and the last case; the values of all lists are read.
SceneDescription describe_sweep(const SweepFile& sweep) {
  check_values(sweep);
  SceneDescription out;
  const std::size_t last = sweep.size() - 1;
  for (const std::size_t i : last > 0 ? std::vector<std::size_t>{0, last} : std::vector<std::size_t>{0}) {
    out.lines.push_back(fmt::format("case {} of {}: {}", i + 1, sweep.size(), sweep.describe(i)));
    out.add(describe_scene(sweep.scene(i)));
  }
  return out;
}

ExitCode run_check(const SceneArguments& arguments) {
  const SceneText given = read_scene_text(arguments.file);
  if (arguments.inputs) {
    for (const std::string& file : named_inputs(given))
      fmt::print("{}\n", file);
    return success;
  }
  const SceneDescription found =
      has_sweep(given) ? describe_sweep(parse_sweep_file(given)) : describe_scene(parse_scene_file(given));
  for (const std::string& line : found.lines)
    print_out("{}\n", line);
  if (arguments.strict)
    refuse_warnings(found.warnings);
  for (const Warning& warning : found.warnings)
    print_out("warning: {}\n", warning.text);
  return success;
}

/// The subcommand with what all three have: the scene file and a tutorial.
CLI::App* add_scene_command(CLI::App& program, const char* name, const char* what, const std::string& help,
                            SceneArguments& arguments) {
  CLI::App* line = program.add_subcommand(name, what);
  line->add_option("scene", arguments.file, "Scene file (TOML)")->required();
  add_strict(*line, arguments.strict);
  line->footer(help);
  return line;
}

void add_threads(CLI::App& line, int& threads) {
  line.add_option(
          "--threads", threads,
          "Threads that share the work of a case by fem with thousands of elements (default 1); results are "
          "the same")
      ->check(CLI::Range(1, most_threads));
}

} // namespace

Command add_solve(CLI::App& program) {
  const auto arguments = std::make_shared<SceneArguments>();
  CLI::App* line = add_scene_command(program, "solve", "Solve a scene",
                                     solve_help_begin + models_help() + solve_help_end, *arguments);
  line->get_option("scene")->description("Scene file (TOML), or a result file (HDF5) to solve again");
  add_model(*line, arguments->model);
  add_json(*line, arguments->json);
  add_output(*line, arguments->output);
  add_threads(*line, arguments->threads);
  line->add_option("--folder", arguments->folder,
                   "With a result file: where the relative paths of its scene start, if it was moved");
  add_output_option(*line, "--vtk", arguments->vtk, "Surface with the result for ParaView (.vts)");
  return {line, [arguments] { return run_solve(*arguments); }};
}

Command add_compare(CLI::App& program) {
  const auto arguments = std::make_shared<SceneArguments>();
  CLI::App* line =
      add_scene_command(program, "compare", "Solve a scene with several models, at equal forces first",
                        compare_help, *arguments);
  line->add_option("--models", arguments->models,
                   "Models to compare, separated by commas (default halfspace,fem)")
      ->delimiter(',')
      ->check(CLI::IsMember(EnumNames<Model>::names));
  add_json(*line, arguments->json);
  add_output(*line, arguments->output);
  add_threads(*line, arguments->threads);
  add_output_option(*line, "--vtk-prefix", arguments->vtk,
                    "Write PREFIX_MODEL.vts of each model for ParaView (at equal forces)");
  return {line, [arguments] { return run_compare(*arguments); }};
}

Command add_check(CLI::App& program) {
  const auto arguments = std::make_shared<SceneArguments>();
  CLI::App* line = add_scene_command(program, "check", "Check a scene and its files; solve nothing",
                                     check_help, *arguments);
  line->add_flag("--inputs", arguments->inputs,
                 "Print the name of each file that the scene reads, one a line, and nothing else; influence "
                 "files need not be there yet");
  return {line, [arguments] { return run_check(*arguments); }};
}

} // namespace bem_contact::app
