#include "bem_contact/app/sweep/whole_sweep.hpp"

#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/sweep/sweep_csv.hpp"
#include "bem_contact/app/sweep/sweep_on_cores.hpp"
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
#include "bem_contact/uses/sweep/sweep_join.hpp"
#include "bem_contact/uses/sweep/sweep_table.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <optional>

namespace bem_contact::app {

namespace {

/// Whether the output is there with all cases, none of which died. Throws InputError if it is not a file of
/// this sweep.
bool is_complete(const std::filesystem::path& output, const AskedSweep& asked) {
  if (!file_exists(output))
    return false;
  std::optional<H5Reader> file;
  H5Table top;
  try {
    top = file.emplace(output).attributes();
  } catch (const InputError&) {
  }
  const auto is = [&](const char* name, const std::string& value) {
    return text_attribute(top, name) == value;
  };
  if (!is("format", sweep_format) || !is("digest", asked.digest))
    throw InputError(fmt::format("The output '{}' exists and is not of this sweep", output.string()),
                     is("format", sweep_format) ? what_changed(*file, asked.origins)
                                                : "it was not made by bem_contact sweep",
                     "Give another output, or remove the file.");
  const auto none = [&](const char* name) { return file->number(name) == 0; };
  return none("missing_count") && none("died_count");
}

/// A sweep of little work, of which nothing is solved yet, in this process.
bool is_small(const AskedSweep& asked, const std::string& output) {
  return !file_exists(output) && !file_exists(parts_folder(output)) && cut_of(asked).little;
}

ExitCode run_small(const AskedSweep& asked, const SweepRequest& request) {
  say_what_is_kept(asked.sweep);
  Progress progress("cases", asked.sweep.size());
  solve_whole(asked, request.output, [&] { progress.step(); });
  progress.finish();
  return say_what_was_found(asked, request, "");
}

} // namespace

void require_sweep_outputs(const SweepFile& sweep, const SweepRequest& request,
                           std::vector<std::filesystem::path> inputs) {
  if (!request.csv.empty())
    require_csv_texts(sweep);
  const CsvFiles csv = csv_files(request.csv);
  std::ranges::copy(files_read(request.scene, sweep), std::back_inserter(inputs));
  require_named_outputs(inputs, {{"--output", request.output, OutputForm::whole_file, true},
                                 {"--csv", request.csv},
                                 {.option = "--csv", .file = csv.patches, .begins_with = patches_begin},
                                 {.option = "--csv", .file = csv.units, .begins_with = units_begin}});
}

AskedSweep asked_sweep(const SweepRequest& request, SweepFile sweep) {
  columns_of(sweep); // refuses derivatives that are no columns
  AskedSweep asked{request.scene, std::move(sweep), request.model, request.strict};
  asked.origins = origins_of(asked.sweep, request.options());
  asked.digest = digest_of(asked.origins);
  return asked;
}

void say_what_is_kept(const SweepFile& sweep) {
  if (!sweep.fields && !sweep.keeps_fields())
    say_info("of {} cases only the totals are kept: fields = true in [sweep] keeps the fields, some 0.2 MB "
             "a case",
             sweep.size());
}

ExitCode say_what_was_found(const AskedSweep& asked, const SweepRequest& request, const std::string& head) {
  const H5Reader file(request.output);
  if (!request.csv.empty())
    write_csv(csv_files(request.csv), asked.sweep, asked.columns(), file);
  const SweepSummary summary = sweep_summary(file, asked.sweep.size());
  print_out("{}{}{}", head, record::found_text(record::read_hdf5_for_found(request.output)), summary.more);
  return summary.certified ? success : no_convergence;
}

ExitCode solve_whole_sweep(const SweepRequest& request, SweepFile sweep) {
  require_sweep_outputs(sweep, request, {});
  check_cases(sweep, sweep.all());
  const AskedSweep asked = asked_sweep(request, std::move(sweep));
  if (is_small(asked, request.output))
    return run_small(asked, request);
  const PartsFolder folder(asked, request.output);
  std::string head;
  if (is_complete(request.output, asked)) {
    head = fmt::format("'{}' is complete: nothing was solved\n", request.output);
    require_table(H5Reader(request.output), asked.columns(), asked.sweep.size());
    folder.clear(folder.parts()); // a kill left them after the file was done
  } else {
    say_what_is_kept(asked.sweep);
    const SolvedParts solved = solve_on_cores(folder, request.jobs, part_solver(asked));
    if (solved.code != 0)
      return static_cast<ExitCode>(solved.code);
    const std::vector<SweepPart> parts = folder.parts();
    join(asked, parts, solved.died, request.output);
    if (solved.died.empty())
      folder.clear(parts);
  }
  return say_what_was_found(asked, request, head);
}

} // namespace bem_contact::app
