#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/sweep/whole_sweep.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/found.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/scene/sweep_check.hpp"
#include "bem_contact/sequence/shared_files.hpp"
#include "bem_contact/uses/sweep/sweep_inputs.hpp"
#include "bem_contact/uses/sweep/sweep_join.hpp"
#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fmt/format.h>
#include <iterator>
#include <memory>
#include <optional>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* sweep_help =
    R"(Add a table [sweep] to a scene; it gives lists or ranges for any keys of the scene:
    [sweep]
    position.lateral = { from = 6.2, to = 7.1, step = 0.05 }   # both ends included; or count = 19 for step
    load.force = [ 5e4, 1e5 ]
    mode = "product"        # the default: every value with every other; "zip": the lists side by side
    fields = true           # the default up to 1000 cases; false: keep only the totals of each case
Example, 64 contacts from tread to flange:
    bem_contact sweep data/scenes/cases_halfspace.toml -o sweep.h5 --csv sweep.csv
You should see the progress, then `64 of 64 cases are certified`. A sweep of a second or less is solved in one
process. A longer one is shared among processes; if it is stopped, call it again: the folder sweep.h5.parts holds the
finished cases, and only the others are solved. So is a case whose process died, as when memory ran out.

On many machines, each solves some of the cases in a process of its own. Join these parts when they are there:
    bem_contact sweep SCENE.toml --count                            # prints how many cases there are
    bem_contact sweep SCENE.toml -o PARTS/a.h5 --cases 0:3200       # cases 0 to 3199
    bem_contact sweep SCENE.toml -o PARTS/b.h5 --cases 3200:6400
    bem_contact sweep SCENE.toml --join PARTS/*.h5 -o SWEEP.h5 --csv SWEEP.csv
More, and wheelsets: data/tutorial/sweep.md, data/tutorial/wheelset.md.

Exit code 0: every case is certified (--cases: the file is written). 2: the input is wrong. 3: a case is missing or not
certified.)";

struct PartsRequest : SweepRequest {
  std::string cases;              ///< "3200:6400"; "": all
  std::vector<std::string> parts; ///< to be joined
  bool count = false;             ///< solve nothing: say how many cases there are
  bool all_cases = false;         ///< of --join: a missing case is an error
  bool damaged = false;           ///< of --join: only name the parts that are damaged
  std::vector<std::string> gone;  ///< options of former versions
};

[[noreturn]] void refuse_gone(const PartsRequest&) {
  throw InputError(
      "--part and --merge are gone", "a part of a sweep is now a command of its own",
      "Solve some cases with -o PART.h5 --cases 0:3200, and join the parts with --join PARTS/*.h5; "
      "tools/cluster does both.");
}

CaseRange range_of(const std::string& text, std::size_t cases) {
  CaseRange range;
  const char *at = text.data(), *end = at + text.size();
  const auto first = std::from_chars(at, end, range.first);
  const bool colon = first.ec == std::errc() && first.ptr != end && *first.ptr == ':';
  const auto second = colon ? std::from_chars(first.ptr + 1, end, range.last) : first;
  const auto refuse = [&](const std::string& why) {
    throw InputError(fmt::format("--cases {} cannot be", text), why,
                     fmt::format("Give two numbers from 0:1 to {}:{}.", cases - 1, cases));
  };
  if (!colon || second.ec != std::errc() || second.ptr != end)
    refuse("it is not of the form 3200:6400, the cases 3200 to 6399");
  if (range.first >= range.last)
    refuse("there is no case in it");
  if (range.last > cases)
    refuse(fmt::format("the sweep has {}, from 0 on", counted(cases, "case", "cases")));
  return range;
}

/// Some cases, in this process.
ExitCode run_part(const PartsRequest& request, SweepFile sweep) {
  const CaseRange cases = range_of(request.cases, sweep.size());
  require_sweep_outputs(sweep, request, {});
  require_replaceable(request.output, sweep_part_format, "a part of a sweep");
  check_cases(sweep, cases);
  const AskedSweep asked = asked_sweep(request, std::move(sweep));
  Progress progress("cases", cases.size());
  solve_part(asked, cases, output_target(request.output, OutputForm::whole_file).file,
             [&] { progress.step(); });
  progress.finish();
  const SweepSummary summary = sweep_summary(H5Reader(request.output), cases.size());
  print_out("cases {} to {} of {}: {}{}", cases.first, cases.last - 1, asked.sweep.size(), summary.counts,
            summary.more);
  return success;
}

/// In quotes for a shell.
std::string shell_word(const std::string& word) {
  std::string out = "'";
  for (const char c : word)
    c == '\'' ? out.append("'\\''") : out.append(1, c);
  return out + "'";
}

/// With the command that solves each.
void print_missing(const PartsRequest& request, const std::vector<CaseRange>& missing) {
  if (!missing.empty())
    print_out("These commands solve the cases that are missing:\n");
  for (const CaseRange& cases : missing)
    print_out("    bem_contact sweep {} -o cases_{}_{}.h5 --cases {}:{}{}{}\n", shell_word(request.scene),
              cases.first, cases.last, cases.first, cases.last,
              request.model.empty() ? "" : " --model " + request.model, request.strict ? " --strict" : "");
}

void require_all_cases(const PartsRequest& request, const std::vector<CaseRange>& missing) {
  std::size_t count = 0;
  for (const CaseRange& cases : missing)
    count += cases.size();
  if (!request.all_cases || count == 0)
    return;
  print_missing(request, missing);
  throw InputError(counted(count, "case", "cases") + " cannot be joined",
                   "no part has them, and --all-cases asks for every one", "Solve them (see above).");
}

/// Reads every number where that failed, so that all damaged parts are named at once.
void join_whole_parts(const AskedSweep& asked, const std::vector<SweepPart>& parts,
                      const std::vector<std::filesystem::path>& names, const std::string& output) {
  try {
    join(asked, parts, {}, output);
  } catch (const InputError&) {
    require_parts(find_parts(asked, names, PartCheck::all));
    throw;
  }
}

ExitCode run_join(const PartsRequest& request, SweepFile sweep) {
  const std::vector<std::filesystem::path> names =
      files_of_parts({request.parts.begin(), request.parts.end()});
  require_sweep_outputs(sweep, request, names);
  require_replaceable(request.output, sweep_format, "the cases of a sweep");
  say_what_is_kept(sweep);
  const AskedSweep asked = asked_sweep(request, std::move(sweep));
  const std::vector<SweepPart> parts = read_parts(asked, names);
  const std::vector<CaseRange> missing = missing_ranges(parts, asked.sweep.size());
  require_all_cases(request, missing);
  join_whole_parts(asked, parts, names, request.output);
  const ExitCode code = say_what_was_found(asked, request, "");
  print_missing(request, missing);
  return code;
}

/// For programs: the name of each damaged part, one a line.
ExitCode print_damaged(const PartsRequest& request, SweepFile sweep) {
  const std::vector<std::filesystem::path> names(request.parts.begin(), request.parts.end());
  const AskedSweep asked = asked_sweep(request, std::move(sweep));
  for (const std::filesystem::path& file : find_parts(asked, names, PartCheck::all).damaged)
    print_out("{}\n", file.string());
  return success;
}

ExitCode run_sweep(const PartsRequest& request) {
  if (!request.gone.empty())
    refuse_gone(request);
  SweepFile sweep = read_sweep_file(request.scene);
  if (request.count) {
    print_out("{}\n", sweep.size());
    return success;
  }
  if (request.damaged)
    return print_damaged(request, std::move(sweep));
  if (request.output.empty())
    throw CLI::RequiredError("--output");
  if (!request.cases.empty())
    return run_part(request, std::move(sweep));
  return request.parts.empty() ? solve_whole_sweep(request, std::move(sweep))
                               : run_join(request, std::move(sweep));
}

} // namespace

Command add_sweep(CLI::App& program) {
  const auto request = std::make_shared<PartsRequest>();
  PartsRequest& r = *request;
  CLI::App* line = program.add_subcommand("sweep", "Solve a scene for lists or ranges of any of its keys");
  line->add_option("scene", r.scene, "Scene file (TOML) with a table [sweep]")->required();
  add_output_option(*line, "-o,--output", r.output, "File of all cases (HDF5)");
  CLI::Option* csv = add_output_option(
      *line, "--csv", r.csv,
      "S.csv: a line for each case; beside it S_patches.csv with a line for each patch, and "
      "S_units.csv with unit and meaning of each column");
  add_model(*line, r.model);
  line->add_flag("--strict", r.strict, "Count a case with a warning as refused, and keep no result of it");
  add_jobs(*line, r.jobs);
  CLI::Option* jobs = line->get_option("--jobs");
  line->add_flag("--count", r.count, "Solve nothing; print how many cases there are");
  CLI::Option* cases =
      line->add_option("--cases", r.cases,
                       "A:B: solve the cases A to B - 1 (the first is 0) in this process, and write a part");
  cases->excludes(jobs)->excludes(csv);
  CLI::Option* parts = line->add_option(
      "--join", r.parts, "Solve nothing; make the file of all from these parts, or from all in a folder");
  parts->excludes(cases)->excludes(jobs);
  line->add_flag("--all-cases", r.all_cases, "With --join: write nothing if a case is missing")->needs(parts);
  line->add_flag("--damaged", r.damaged,
                 "With --join: write nothing; print the name of each damaged part, one a line")
      ->needs(parts);
  line->add_option("--part,--merge", r.gone)->expected(0, 1)->group(""); // hidden
  line->footer(sweep_help);
  return {line, [request] { return run_sweep(*request); }};
}

} // namespace bem_contact::app
