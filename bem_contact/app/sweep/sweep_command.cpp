#include "bem_contact/app/command.hpp"
#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/sweep/sweep_inputs.hpp"
#include "bem_contact/app/sweep/sweep_journal.hpp"
#include "bem_contact/app/sweep/sweep_output.hpp"
#include "bem_contact/app/sweep/sweep_share.hpp"
#include "bem_contact/app/sweep/sweep_workers.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/interrupt_note.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/record/file_kinds.hpp"
#include "bem_contact/record/hdf5.hpp"
#include "bem_contact/sequence/result_file.hpp"
#include "bem_contact/sequence/shared_files.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <utility>
#include <vector>

namespace bem_contact::app {

namespace {

constexpr const char* sweep_help =
    R"(Add a table [sweep] to a scene; it gives lists or ranges for any keys of the scene:
    [sweep]
    position.lateral = { from = 6.2, to = 7.1, step = 0.05 }   # both ends included; or count = 19 for step
    load.force = [ 5e4, 1e5 ]
    mode = "product"        # the default: every value with every other; "zip": the lists side by side
    fields = true           # the default; false: keep only the totals of each case
Example, 64 contacts from tread to flange:
    bem_contact sweep data/scenes/cases_halfspace.toml -o sweep.h5 --csv sweep.csv
You should see the progress, then `64 certified, of 64 cases`. If the program is stopped, call it again: sweep.h5.part
holds the finished cases, and only the others are solved. So is a case whose process died, as when memory ran out.

Machines that see the same folder can share the cases (tools/cluster/slurm_sweep). Join the shares when all are done:
    bem_contact sweep SCENE.toml -o SWEEP.h5 --part 1/8        # ... --part 8/8
    bem_contact sweep SCENE.toml -o SWEEP.h5 --merge
More, and wheelsets: data/tutorial/sweep.md, data/tutorial/wheelset.md.

Exit code 0: every case is certified (of a share: every case of the share). 2: the input is wrong. 3: a case is missing
or not certified.)";

struct SweepRequest {
  std::string scene, output, csv, model;
  int jobs = 0;        ///< processes; 0: one for each core
  std::string part;    ///< "2/8": the second of eight shares; "": all
  bool merge = false;  ///< solve nothing: write what the shares have solved
  bool strict = false; ///< a case with a warning is refused

  /// What changes the results besides the scene.
  std::string options() const { return model + (strict ? " strict" : ""); }
};

/// Whether the output is there with all cases, none of which died. Throws InputError if it is not a file of
/// this sweep.
bool is_complete(const std::filesystem::path& output, const std::string& digest) {
  if (!file_exists(output))
    return false;
  H5Table top;
  try {
    top = read_h5_top(output);
  } catch (const InputError&) {
  }
  const auto is = [&](const char* name, const std::string& value) {
    return text_attribute(top, name) == value;
  };
  if (!is("format", sweep_format) || !is("digest", digest))
    throw InputError(fmt::format("The output '{}' exists and is not of this sweep", output.string()),
                     is("format", sweep_format) ? digest_changed : "it was not made by bem_contact sweep",
                     "Give another output, or remove the file.");
  const auto none = [&](const char* name) {
    const auto found = top.datasets.find(name);
    return found != top.datasets.end() && found->second.values == std::vector<double>{0};
  };
  return none("missing_count") && none("died_count");
}

CaseRecord solved(SweepSolver& solver, const SweepFile& sweep, std::size_t index,
                  const SweepRequest& request) {
  H5Table fields;
  SweepOptions options{.model = request.model, .strict = request.strict};
  if (sweep.fields)
    options.seen = [&](const std::string& group, const SceneResult& result) {
      add_group(fields, group, record::to_h5(case_record(result)));
    };
  return {solve_case(solver, sweep, index, options), std::move(fields)};
}

/// Here, so that messages about them come once and not from each process.
void read_first_profiles(const SweepFile& sweep, SequenceFiles& files) {
  try {
    if (const SceneFile first = sweep.scene(0); first.kind == SceneKind::wheel_rail)
      read_profiles(first, files);
  } catch (const InputError&) { // the cases say it
  }
}

void solve_missing(const SweepFile& sweep, const SweepRequest& request, const Share& share,
                   SweepJournal& journal, SweepOutput& output) {
  const std::vector<Chunk> chunks = chunks_of(output, sweep.size(), share);
  std::size_t cases = 0;
  for (const Chunk& chunk : chunks)
    cases += chunk.size();
  if (cases == 0)
    return;
  Progress progress("cases", cases);
  InterruptNote note("cases", fmt::format("Give the same command again to go on: '{}' holds them.",
                                          journal_name(request.output, share.part, share.parts).string()));
  std::size_t done = 0;
  note.done(done, cases);
  const auto keep = [&](const CaseRecord& record, const std::string& bytes) {
    journal.append(bytes);
    output.add(record);
    progress.step();
    note.done(++done, cases);
  };
  WorkerCalls calls;
  const auto files = shared_files(); // each worker fills its own copy
  read_first_profiles(sweep, *files);
  calls.make_solver = [&]() -> CaseSolver {
    const auto solver = std::make_shared<SweepSolver>(files, sweep.fields);
    return [&, solver](std::size_t index) { return to_bytes(solved(*solver, sweep, index, request)); };
  };
  calls.done = [&](std::size_t, std::string bytes) { keep(from_bytes(bytes), bytes); };
  calls.failed = [&](std::size_t index, CaseFailure, const std::string& reason) {
    const CaseRecord record{{.index = index, .status = CaseStatus::died, .reason = reason}};
    keep(record, to_bytes(record));
  };
  solve_in_processes(chunks, request.jobs, calls);
  progress.finish();
}

/// From the journals, case by case: fields need not fit into memory.
void write_file(const std::filesystem::path& file, const std::vector<std::filesystem::path>& journals,
                const std::string& digest, const SweepOutput& output, const GivenScene& given) {
  const std::size_t cases = output.size();
  H5Writer writer(file);
  std::vector<char> written(cases, 0);
  for (const std::filesystem::path& journal : journals)
    read_journal(journal, digest, [&](const CaseRecord& record) {
      // A later run may have solved what died.
      if (record.index >= cases || record.status != output.status(record.index) ||
          std::exchange(written[record.index], 1))
        return;
      writer.add(group_of(record));
    });
  H5Table top = output.top();
  add_group(top, "", record::to_h5(headed(sweep_format, given, file)));
  writer.add(top);
  writer.finish();
}

void check_outputs(const SweepFile& sweep, const SweepRequest& request,
                   const std::filesystem::path& own_journal) {
  if (!request.csv.empty())
    require_csv_texts(sweep);
  const CsvFiles csv = csv_files(request.csv);
  require_named_outputs(files_read(request.scene, sweep),
                        {{"--output", request.output, OutputForm::whole_file, true},
                         {"--output", own_journal, OutputForm::whole_file},
                         {"--csv", request.csv},
                         {"--csv", csv.patches},
                         {"--csv", csv.units}});
}

/// What is known from all journals, after this process has solved its part of the rest.
SweepOutput results_of(const SweepFile& sweep, const SweepColumns& columns, const SweepRequest& request,
                       const Share& share, const std::filesystem::path& own_journal,
                       const std::string& digest) {
  SweepOutput results(sweep, columns, digest);
  const auto add = [&](const CaseRecord& record) { results.add(record); };
  for (const std::filesystem::path& journal : journals_of(request.output))
    if (request.merge || journal != own_journal)
      read_journal(journal, digest, add);
  if (!request.merge) {
    SweepJournal journal(own_journal, digest, add);
    if (!journal.warning().empty())
      warn({journal.warning()});
    solve_missing(sweep, request, share, journal, results);
  }
  return results;
}

void remove_journals(const std::filesystem::path& output) {
  for (const std::filesystem::path& journal : journals_of(output))
    std::filesystem::remove(journal);
}

/// Solves the cases that are not solved yet and writes them into one file (sweep_output.hpp). A share writes
/// only its journal (sweep_journal.hpp); --merge makes the file of all journals. Throws InputError for wrong
/// input, an output of another sweep, or files that cannot be written. What is wrong with one case is in its
/// record.
SweepSummary run_sweep(const SweepRequest& request) {
  const SweepFile sweep = read_sweep_file(request.scene);
  const Share share = share_of(request.part);
  check_values(sweep);
  const SweepColumns& columns = columns_of(sweep);
  const std::filesystem::path output = request.output;
  const std::filesystem::path own_journal = journal_name(output, share.part, share.parts);
  check_outputs(sweep, request, own_journal);
  const std::string digest = digest_of(sweep, request.options());
  std::string head;
  if (is_complete(output, digest)) {
    head = fmt::format("'{}' is complete: nothing was solved\n", output.string());
    for (const std::filesystem::path& journal : journals_of(output)) // a kill left it after the file was done
      if (read_journal(journal, digest, [](const CaseRecord&) {}) > 0)
        std::filesystem::remove(journal);
  } else {
    const GivenScene given = given_sweep(sweep, request.model);
    const SweepOutput results = results_of(sweep, columns, request, share, own_journal, digest);
    if (share.parts > 1)
      return summary_of(
          results.top(), share,
          fmt::format("share {} of {} is solved: --merge makes the file of all\n", share.part, share.parts));
    write_file(output, journals_of(output), digest, results, given);
    if (results.count(CaseStatus::missing) == 0 && results.count(CaseStatus::died) == 0)
      remove_journals(output);
  }
  const H5Table top = read_sweep_top(output, sweep, columns);
  if (!request.csv.empty())
    write_csv(csv_files(request.csv), sweep, columns, top);
  return summary_of(top, share, head);
}

} // namespace

Command add_sweep(CLI::App& program) {
  const auto request = std::make_shared<SweepRequest>();
  SweepRequest& r = *request;
  CLI::App* line = program.add_subcommand("sweep", "Solve a scene for lists or ranges of any of its keys");
  line->add_option("scene", r.scene, "Scene file (TOML) with a table [sweep]")->required();
  add_output_option(*line, "-o,--output", r.output, "File of all cases (HDF5)")->required();
  add_output_option(*line, "--csv", r.csv,
                    "S.csv: a line for each case; beside it S_patches.csv with a line for each patch, and "
                    "S_units.csv with unit and meaning of each column");
  add_model(*line, r.model);
  line->add_flag("--strict", r.strict, "Count a case with a warning as refused, and keep no result of it");
  add_jobs(*line, r.jobs);
  CLI::Option* part = line->add_option("--part", r.part, "I/N: solve the I-th of N shares");
  line->add_flag("--merge", r.merge, "Solve nothing; join what the shares have solved")->excludes(part);
  line->footer(sweep_help);
  return {line, [request] {
            const SweepSummary summary = run_sweep(*request);
            fmt::print("{}", summary.text);
            return summary.certified ? success : no_convergence;
          }};
}

} // namespace bem_contact::app
