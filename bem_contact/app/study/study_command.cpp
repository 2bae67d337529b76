#include "bem_contact/app/command.hpp"
#include "bem_contact/app/scene_options.hpp"
#include "bem_contact/app/study/input_spread.hpp"
#include "bem_contact/app/study/study_parts.hpp"
#include "bem_contact/app/study/study_record.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/report/report_page.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>

namespace bem_contact::app {

namespace {

constexpr const char* study_help =
    R"(One scene file asks for all answers. Without more it is solved; each of these tables asks for what the command of its
name gives, and may have the command's options as keys (wear.depth for wear --depth):
    [wheelset] [sweep] [compare] [conicity] [creep_curves] [fit] [table] [fatigue] [shakedown] [wear]
    [influence]    rail = "BODY.toml": compute rail.influence where it is missing (tools/influence); so wheel
    [uncertainty]  friction, load, lateral, profile_noise: standard deviations of the inputs; draws, seed, parts;
                   states = "clean, rig, locomotive": the same numbers for other states of the surfaces (layer.state)
Example:
    bem_contact new --wheel S1002 --rail 60E1 --curve 300 --load 80e3 -o curve.toml
    bem_contact study curve.toml -o curve
You should see what was given and what was taken by default, how each part went, and the numbers that people look at first, each
with its error by the size of the elements. The folder has study.html (a page), study.h5 (all results), and a CSV file for
each table of numbers. Call it again at any time: only what is missing or no longer true is computed.

With [wheelset], creep_curves, table, compare and fatigue are of the wheel to which the wheelset is displaced, where the
equilibrium puts it. More: data/tutorial/study.md.

On many machines: --list prints the parts and draws of a study, --only PART computes one of them. Call study without both at last: it
finds them in the folder. [influence] comes first, then [wheelset]; all others may run side by side.

Exit code: the worst of the parts. 0: all is certified; 2: a part is refused; 3: a part is not certified.)";

constexpr const char *study_file = "study.h5", *study_page = "study.html", *study_table = "study.csv";

struct StudyArguments {
  std::string scene;
  std::filesystem::path folder;
  int jobs = 0;
  std::string influence; ///< program; "": tools/influence, and no other
  std::vector<std::string> only;
  bool list = false;
};

std::string name_of_state(const std::string& state) {
  return "states/" + state;
}

std::string name_of_draw(int draw) {
  return fmt::format("draws/{:04}", draw);
}

/// What a study computes, in the order of its work.
std::vector<std::string> tasks_of(const StudyCase& study) {
  std::vector<std::string> out;
  for (const Part& part : all_parts())
    if (part.asked(study))
      out.emplace_back(part.name);
  for (int draw = 1; draw <= draws_of(study); ++draw)
    out.push_back(name_of_draw(draw));
  for (const std::string& state : study.uncertainty.states)
    out.push_back(name_of_state(state));
  return out;
}

std::string taken_text(const SceneText& scene) {
  std::string given, taken;
  for (const TakenValue& value : taken_values(scene)) {
    std::string& list = value.given ? given : taken;
    list += fmt::format("{}{} = {}{}", list.empty() ? "" : ", ", value.key, value.value,
                        value.unit.empty() ? "" : " " + value.unit);
  }
  return fmt::format("given: {}\nby default: {}\n", given, taken.empty() ? "nothing that matters" : taken);
}

void print_part(const PartResult& result) {
  print_out("{:13} {:14} {}{}\n", result.part->name, name_of(outcome_of(result)),
            result.kept ? "as it was" : duration_text(result.seconds),
            result.about.empty() ? "" : "  " + result.about);
  for (const std::string& error : result.errors)
    print_out("{:13} {}\n", "", error);
  std::fflush(stdout);
}

std::string headline_text(const std::vector<HeadlineNumber>& headline, bool drawn) {
  std::string out = fmt::format("{:13} {:38} {:>12} {:>12}{}\n", "part", "number", "value", "+- elements",
                                drawn ? fmt::format(" {:>12}", "+- inputs") : "");
  for (const HeadlineNumber& n : headline)
    out += fmt::format("{:13} {:38} {:>12} {:>12}{} {}\n", n.part->name, n.name,
                       record::digits_fine(n.value, n.element_error, 5), record::two_digits(n.element_error),
                       drawn ? fmt::format(" {:>12}", record::two_digits(n.input_spread)) : "",
                       n.unit == "1" ? "" : n.unit);
  return out;
}

std::string states_text(const std::vector<HeadlineNumber>& headline, const std::vector<std::string>& states) {
  if (states.empty())
    return "";
  std::string out = fmt::format("{:13} {:38} {:>12}", "by state", "number", "as given");
  for (const std::string& state : states)
    out += fmt::format(" {:>11}", state);
  for (const HeadlineNumber& n : headline) {
    if (std::ranges::all_of(n.by_state, [](double value) { return std::isnan(value); }))
      continue;
    out += fmt::format("\n{:13} {:38} {:>12.5g}", n.part->name, n.name, n.value);
    for (const double value : n.by_state)
      out += std::isnan(value) ? fmt::format(" {:>11}", "-") : fmt::format(" {:>11.5g}", value);
    out += n.unit == "1" ? "" : " " + n.unit;
  }
  return out + "\n";
}

GivenScene given_for_study(const SceneText& text) {
  if (has_sweep(text))
    return given_sweep(parse_sweep_file(text), "");
  GivenScene given{text, "", parse_scene_file(text), {}};
  given.inputs = inputs_of(given.scene);
  return given;
}

/// False where this build draws no pages.
bool write_page_of(const std::filesystem::path& file, const std::filesystem::path& page) {
  try {
    report::write_report(file, page);
    return true;
  } catch (const InputError& error) {
    warn({fmt::format("There is no page: {}", error.what())});
    return false;
  }
}

/// Files that must not be replaced.
std::vector<std::filesystem::path> inputs_of_study(const StudyCase& study,
                                                   const std::filesystem::path& scene) {
  std::vector<std::filesystem::path> out{scene};
  for (const std::string& body : {study.influence.rail, study.influence.wheel})
    if (!body.empty())
      out.push_back(study.text.folder / body);
  try {
    std::ranges::move(has_sweep(study.text) ? files_read(scene, parse_sweep_file(study.text))
                                            : files_read(scene, parse_scene_file(study.text)),
                      std::back_inserter(out));
  } catch (const InputError&) { // the parts say it
  }
  return out;
}

int worst_of(const std::vector<PartResult>& results) {
  int worst = success;
  for (const PartResult& result : results)
    worst = std::max(worst, result.code);
  return std::min<int>(worst, no_convergence);
}

/// Some parts and draws, for a study that is put together later.
ExitCode run_only(const StudyCase& study, StudyFolder where, const std::vector<std::string>& only) {
  const std::vector<std::string> tasks = tasks_of(study);
  for (const std::string& name : only)
    if (std::ranges::count(tasks, name) == 0)
      throw InputError(fmt::format("--only has '{}'", name), "the study has no such part",
                       fmt::format("It has {}.", fmt::join(tasks, ", ")));
  where.inputs = inputs_of_study(study, where.scene);
  make_study_folder(where);
  std::set<std::string> said;
  where.wanted = only; // a draw is no part
  int worst = worst_of(run_parts(study, where, said, print_part));
  const auto drawn = [&](int draw) { return std::ranges::count(only, name_of_draw(draw)) > 0; };
  if (std::ranges::any_of(only, [](const std::string& name) { return name.starts_with("draws/"); }))
    for (const std::vector<PartResult>& results : solve_draws(study, where, said, drawn))
      worst = std::max(worst, worst_of(results));
  const auto varied = [&](const std::string& state) {
    return std::ranges::count(only, name_of_state(state)) > 0;
  };
  for (const std::vector<PartResult>& results : solve_states(study, where, said, varied))
    worst = std::max(worst, worst_of(results));
  return static_cast<ExitCode>(worst);
}

ExitCode run_study(const StudyArguments& arguments) {
  StudyCase study = study_case(read_scene_text(arguments.scene));
  if (arguments.list) {
    print_out("{}\n", fmt::join(tasks_of(study), "\n"));
    return success;
  }
  for (const auto& [table, key] : {std::pair{"influence", "program"}, {"wear", "influence"}})
    require_repeated_program(study.text, table, key, arguments.influence);
  StudyFolder where{arguments.scene, arguments.folder, arguments.jobs};
  where.program = arguments.influence;
  if (!where.program.empty())
    study.influence.program = where.program;
  if (!arguments.only.empty())
    return run_only(study, where, arguments.only);
  const std::vector<std::string>& states = study.uncertainty.states;
  const GivenScene given = given_for_study(study.text);
  where.inputs = inputs_of_study(study, where.scene);
  make_folder(where.folder);
  OutputFolder made(where.folder, {.maker = study_maker, .alone = false, .inputs = where.inputs});
  for (const char* name : {study_file, study_page, study_table})
    made.require(name);
  make_study_folder(where);
  const LockFile lock(arguments.folder / ".study", "Wait for it, or give another folder.");
  if (!lock.warning().empty())
    warn({lock.warning()});
  print_out("{}", taken_text(study.text));
  std::fflush(stdout);
  std::set<std::string> said;
  const std::vector<PartResult> results = run_parts(study, where, said, print_part);
  std::vector<HeadlineNumber> headline = headline_of(results);
  const bool drawn = study.uncertainty.asked();
  if (drawn)
    warn(draw_inputs(study, where, said, headline));
  if (!states.empty())
    warn(vary_states(study, where, said, headline));
  const std::filesystem::path file = made.take(study_file);
  const record::Record answer = study_record(given, file, results, headline, states);
  record::write_hdf5(file, answer);
  made.done(study_file);
  const std::vector<std::string> tables = write_tables(made, results, headline, states);
  const bool has_page = write_page_of(file, made.take(study_page));
  made.done(study_page);
  std::vector<std::string> kept = tables;
  kept.insert(kept.end(), {study_file, study_page});
  made.remove_others(kept); // of parts that the scene does not ask for any more
  print_out("\n{}{}{}{}: {}study.h5, {}\n", record::found_text(answer), headline_text(headline, drawn),
            states_text(headline, states), arguments.folder.string(), has_page ? "study.html, " : "",
            fmt::join(tables, ", "));
  return static_cast<ExitCode>(worst_of(results));
}

} // namespace

Command add_study(CLI::App& program) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* line =
      program.add_subcommand("study", "All answers to one scene: results, tables and a page in a folder");
  line->add_option("scene", arguments->scene, "Scene file (TOML) with a table for each answer")->required();
  add_output_option(*line, "-o,--output", arguments->folder, "Folder of the answers")->required();
  add_jobs(*line, arguments->jobs);
  line->add_option(
      "--influence", arguments->influence,
      "Program that may be started for influence functions: called with a body file and the file "
      "to write (default: tools/influence). One that the scene names must be repeated here");
  line->add_flag("--list", arguments->list, "Print the names of its parts and draws; nothing is computed");
  line->add_option("--only", arguments->only,
                   "Compute only these of --list; neither study.h5 nor a page is made")
      ->delimiter(',')
      ->excludes("--list");
  line->footer(study_help);
  return {line, [arguments] { return run_study(*arguments); }};
}

} // namespace bem_contact::app
