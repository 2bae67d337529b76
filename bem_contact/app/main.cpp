#include "bem_contact/app/influence_command.hpp"
#include "bem_contact/app/info.hpp"
#include "bem_contact/app/report.hpp"
#include "bem_contact/app/result_file.hpp"
#include "bem_contact/app/sweep_command.hpp"
#include "bem_contact/app/vtk_file.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

namespace {

using namespace bem_contact;

enum ExitCode { success = 0, wrong_input = 2, no_convergence = 3 };

struct Arguments {
  std::string file, model, output, vtk;
  bool json = false, print_default = false;
};

/// Refuses, before anything is computed, an output that is an input or another output.
void check_outputs(const Arguments& arguments, const SceneFile& scene,
                   std::vector<std::filesystem::path> outputs) {
  std::vector<std::filesystem::path> taken{arguments.file};
  std::ranges::move(input_files(scene), std::back_inserter(taken));
  for (std::filesystem::path& output : outputs) {
    refuse_overwriting(output, taken);
    taken.push_back(std::move(output));
  }
}

/// A remark and a warning for each that a person would want to know of; 0 only where the certificate holds.
ExitCode verdict(const SceneResult& r) {
  for (const std::string& warning : r.warnings)
    spdlog::warn("{}", warning);
  if (r.result.certificate.holds())
    return std::ranges::all_of(r.history, &ContactResult::converged) ? success : no_convergence;
  spdlog::error(
      "The {} result is not a solution (its worst violation is {:.1e}, {:.0e} is allowed; {}) Coarsen the "
      "grid, lower solver.tolerance, or raise solver.max_outer.",
      name_of(r.model), r.result.certificate.worst(), r.result.certificate.tolerance, r.result.remark);
  return no_convergence;
}

ExitCode run_solve(const Arguments& arguments) {
  SceneFile scene = read_scene_file(arguments.file);
  check_outputs(arguments, scene, {arguments.output, arguments.vtk});
  if (!arguments.model.empty())
    scene.solver.model = model_named(arguments.model);
  const SceneResult result = Sequence().solve(scene);
  if (!arguments.output.empty()) {
    const std::array results{&result};
    write_h5(arguments.output, app::to_table(results, arguments.file));
  }
  if (!arguments.vtk.empty())
    app::write_vts(arguments.vtk, result);
  fmt::print("{}", arguments.json ? app::to_json(result).dump(2) + "\n" : app::to_text(result));
  return verdict(result);
}

ExitCode run_compare(const Arguments& arguments) {
  const SceneFile scene = read_scene_file(arguments.file);
  const std::string halfspace_vts = arguments.vtk + "_halfspace.vts", fem_vts = arguments.vtk + "_fem.vts";
  check_outputs(arguments, scene, {arguments.output, halfspace_vts, fem_vts});
  const Comparison comparison = Sequence().compare(scene);
  if (!arguments.output.empty()) {
    const std::array results{&comparison.halfspace, &comparison.fem};
    write_h5(arguments.output, app::to_table(results, arguments.file));
  }
  if (!arguments.vtk.empty()) {
    app::write_vts(halfspace_vts, comparison.halfspace);
    app::write_vts(fem_vts, comparison.fem);
  }
  fmt::print("{}", arguments.json ? app::to_json(comparison).dump(2) + "\n" : app::to_text(comparison));
  return std::max(verdict(comparison.halfspace), verdict(comparison.fem));
}

ExitCode run_check(const Arguments& arguments) {
  for (const std::string& line : Sequence().check(read_scene_file(arguments.file)))
    fmt::print("{}\n", line);
  return success;
}

std::vector<std::string> model_names() {
  std::vector<std::string> names{std::string(automatic_model)};
  names.insert(names.end(), EnumNames<Model>::names.begin(), EnumNames<Model>::names.end());
  return names;
}

CLI::App* add_expand(CLI::App& influence, app::ExpandRequest& r) {
  CLI::App* expand =
      influence.add_subcommand("expand", "Write the numbers of one body, or of rail and wheel, for a grid");
  expand->add_option("files", r.files, "Influence file of a body, or those of the rail and the wheel")
      ->required()
      ->expected(1, 2);
  expand->add_option("--dx", r.dx, "Length of an element along x, mm")->required();
  expand->add_option("--ds", r.ds, "Width of an element along s, mm")->required();
  expand->add_option("--mx", r.mx, "Offsets along x: 0 .. MX-1 elements")->required();
  expand->add_option("--my", r.my, "Rows along s")->required();
  expand->add_option("--centre", r.centre,
                     "Arc length of the middle of the rows, mm; else the strip's middle");
  expand->add_option("--wheel-centre", r.wheel_centre, "The same on the wheel of a pair");
  expand->add_option("--structural-compliance", r.structural, "The body's motion as a whole")
      ->check(CLI::IsMember({"included", "removed"}))
      ->capture_default_str();
  expand->add_option("--format", r.format, "Else by the output's ending: .h5 or .csv")
      ->check(CLI::IsMember({"hdf5", "csv", "contact"}));
  expand->add_option("--matrices", r.matrices, "Format contact: one matrix, or one for each loaded row")
      ->check(CLI::IsMember({"each", "one"}))
      ->capture_default_str();
  expand->add_option("-o,--output", r.output, "File to write")->required();
  expand->footer("`bem_contact influence --help` has examples.");
  return expand;
}

CLI::App* add_sweep(CLI::App& cli, app::SweepRequest& r) {
  CLI::App* sweep = cli.add_subcommand("sweep", "Solve a scene for lists or ranges of any of its keys");
  sweep->add_option("scene", r.scene, "Scene file (TOML) with a table [sweep]")->required();
  sweep->add_option("-o,--output", r.output, "File of all cases (HDF5)")->required();
  sweep->add_option("--csv", r.csv, "Summary, one line a case");
  sweep->add_option("--model", r.model, "What is taken for the bodies; the scene's own choice if not given")
      ->check(CLI::IsMember(model_names()));
  sweep->add_option("--jobs", r.jobs, "Processes side by side; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  CLI::Option* part = sweep->add_option("--part", r.part, "I/N: solve the I-th of N shares");
  sweep->add_flag("--merge", r.merge, "Solve nothing; write what the shares have solved")->excludes(part);
  sweep->footer(app::sweep_help());
  return sweep;
}

/// Before options are looked at: those of a command that is not known are no error of their own.
void refuse_unknown_command(const CLI::App& cli, const std::string& word) {
  std::vector<std::string> commands;
  for (const CLI::App* command : cli.get_subcommands(nullptr))
    commands.push_back(command->get_name());
  if (word.empty() || word.front() == '-' || std::ranges::count(commands, word) > 0)
    return;
  const auto like = nearest_names(word, commands, 1);
  throw InputError(fmt::format("there is no command '{}'", word),
                   fmt::format("the commands are {}", fmt::join(commands, ", ")),
                   std::filesystem::exists(word) ? fmt::format("Did you mean bem_contact solve {}?", word)
                   : like.empty()                ? "See bem_contact --help."
                                                 : fmt::format("Did you mean {}?", like.front()));
}

} // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("bem_contact"));
  spdlog::set_pattern("%^%l%$: %v");

  Arguments arguments;
  CLI::App cli{"Conformal wheel-rail contact by the boundary element method"};
  cli.require_subcommand(0, 1);
  cli.set_version_flag("--version", provenance("bem_contact"));
  cli.add_flag("--print-default", arguments.print_default,
               "Print a scene file with every key, its default and unit");
  cli.footer(
      "A scene is a TOML file; begin with one of data/scenes, whose README.md says what they can ask.\n"
      "Exit code 0: the certificate holds (sweep: of every case); 2: the input is wrong; 3: no "
      "convergence.\nEach command has a --help of its own.");

  CLI::App* solve = cli.add_subcommand("solve", "Solve a scene");
  solve->add_option("scene", arguments.file, "Scene file (TOML)")->required();
  solve->add_option("--model", arguments.model, "Influence numbers; the scene's own choice if not given")
      ->check(CLI::IsMember(model_names()));
  solve->add_flag("--json", arguments.json, "Print one JSON object on standard output");
  solve->add_option("-o,--output", arguments.output, "Result file (HDF5)");
  solve->add_option("--vtk", arguments.vtk, "Surface with the result for ParaView (.vts)");

  CLI::App* compare = cli.add_subcommand("compare", "Solve a scene with both models at equal vertical force");
  compare->add_option("scene", arguments.file, "Scene file (TOML)")->required();
  compare->add_flag("--json", arguments.json, "Print one JSON object on standard output");
  compare->add_option("-o,--output", arguments.output, "Result file (HDF5)");
  compare->add_option("--vtk-prefix", arguments.vtk,
                      "Write PREFIX_halfspace.vts and PREFIX_fem.vts for ParaView");

  CLI::App* check =
      cli.add_subcommand("check", "Check a scene, its files and what would be solved; solve nothing");
  check->add_option("scene", arguments.file, "Scene file (TOML)")->required();

  CLI::App* info = cli.add_subcommand("info", "Describe an influence file or a result file");
  info->add_option("file", arguments.file, "HDF5 file")->required();

  CLI::App* influence = cli.add_subcommand("influence", "Plain influence numbers from influence files");
  influence->require_subcommand(1);
  influence->footer(app::influence_help());
  app::ExpandRequest request;
  CLI::App* expand = add_expand(*influence, request);

  app::SweepRequest sweep_request;
  CLI::App* sweep = add_sweep(cli, sweep_request);

  try {
    refuse_unknown_command(cli, argc > 1 ? argv[1] : "");
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = cli.exit(error, std::cout, std::cerr); // --help is no error
    return code == 0 ? success : wrong_input;
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return wrong_input;
  }

  try {
    if (arguments.print_default) {
      fmt::print("{}", default_scene_file());
      return success;
    }
    if (*solve)
      return run_solve(arguments);
    if (*compare)
      return run_compare(arguments);
    if (*check)
      return run_check(arguments);
    if (*sweep) {
      const app::SweepSummary summary = app::sweep_command(sweep_request);
      fmt::print("{}", summary.text);
      return summary.certified ? success : no_convergence;
    }
    if (*info) {
      fmt::print("{}", app::describe_file(arguments.file));
      return success;
    }
    if (*expand) {
      request.has_centre = expand->count("--centre") > 0;
      request.has_wheel_centre = expand->count("--wheel-centre") > 0;
      fmt::print("{}", app::expand_command(request));
      return success;
    }
    fmt::print(stderr, "{}", cli.help());
    return wrong_input;
  } catch (const ConvergenceError& error) {
    spdlog::error("{}", error.what());
    return no_convergence;
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return wrong_input;
  } catch (const std::exception& error) {
    spdlog::error("Something this program did not foresee: {}", error.what());
    return wrong_input;
  }
}
