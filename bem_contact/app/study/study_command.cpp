#include "bem_contact/app/command.hpp"
#include "bem_contact/app/study/input_spread.hpp"
#include "bem_contact/app/study/study_parts.hpp"
#include "bem_contact/app/study/study_record.hpp"
#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/record/error_text.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/report/report_page.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>

namespace bem_contact::app {

namespace {

constexpr const char* study_help =
    R"(One scene file asks for all answers. Without more it is solved; each of these tables asks for what the command of its
name gives, and may have the command's options as keys (wear.depth for wear --depth):
    [wheelset] [sweep] [compare] [conicity] [creep_curves] [table] [fatigue] [wear]
    [influence]    rail = "BODY.toml": compute rail.influence where it is missing (tools/influence); so wheel
    [uncertainty]  friction, load, lateral, profile_noise: standard deviations of the inputs; draws, seed, parts
Example:
    bem_contact new --wheel S1002 --rail 60E1 --curve 300 --load 80e3 -o curve.toml
    bem_contact study curve.toml -o curve
You should see what was given and what was taken by default, how each part went, and the numbers that people look at first, each
with its error by the size of the elements. The folder has study.html (a page), study.h5 (all results), and a CSV file for
each table of numbers. Call it again at any time: only what is missing or no longer true is computed.

With [wheelset], creep_curves, table, compare and fatigue are of the wheel to which the wheelset is displaced, where the
equilibrium puts it. More: data/tutorial/study.md.

Exit code: the worst of the parts. 0: all is certified; 2: a part is refused; 3: a part is not certified.)";

struct StudyArguments {
  std::string scene;
  std::filesystem::path folder;
  int jobs = 0;
};

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
  fmt::print("{:13} {:14} {}\n", result.part->name, status_of(result),
             result.kept ? "as it was" : duration_text(result.seconds));
  for (const std::string& error : result.errors)
    fmt::print("{:13} {}\n", "", error);
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

ExitCode run_study(const StudyArguments& arguments) {
  const StudyCase study = study_case(read_scene_text(arguments.scene));
  const GivenScene given = given_for_study(study.text);
  const StudyFolder where{arguments.scene, arguments.folder, arguments.jobs};
  make_study_folder(where);
  const LockFile lock(arguments.folder / ".study", "Wait for it, or give another folder.");
  if (!lock.warning().empty())
    warn({lock.warning()});
  fmt::print("{}", taken_text(study.text));
  std::fflush(stdout);
  std::set<std::string> said;
  const std::vector<PartResult> results = run_parts(study, where, said, print_part);
  std::vector<HeadlineNumber> headline = headline_of(results);
  const bool drawn = study.uncertainty.asked();
  if (drawn)
    warn(draw_inputs(study, where, said, headline));
  const std::filesystem::path file = arguments.folder / "study.h5", page = arguments.folder / "study.html";
  record::write_hdf5(file, study_record(given, file, results, headline));
  const std::vector<std::string> tables = write_tables(arguments.folder, results, headline);
  const bool has_page = write_page_of(file, page);
  fmt::print("{}{}: {}study.h5, {}\n", headline_text(headline, drawn), arguments.folder.string(),
             has_page ? "study.html, " : "", fmt::join(tables, ", "));
  int worst = success;
  for (const PartResult& result : results)
    worst = std::max(worst, result.code);
  return static_cast<ExitCode>(std::min<int>(worst, no_convergence));
}

} // namespace

Command add_study(CLI::App& program) {
  const auto arguments = std::make_shared<StudyArguments>();
  CLI::App* line =
      program.add_subcommand("study", "All answers to one scene: results, tables and a page in a folder");
  line->add_option("scene", arguments->scene, "Scene file (TOML) with a table for each answer")->required();
  add_output_option(*line, "-o,--output", arguments->folder, "Folder of the answers")->required();
  add_jobs(*line, arguments->jobs);
  line->footer(study_help);
  return {line, [arguments] { return run_study(*arguments); }};
}

} // namespace bem_contact::app
