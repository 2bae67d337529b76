#include "bem_contact/app/sweep_command.hpp"

#include "bem_contact/app/sweep_file.hpp"
#include "bem_contact/app/sweep_journal.hpp"
#include "bem_contact/app/sweep_share.hpp"
#include "bem_contact/app/sweep_workers.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/sequence/sequence.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <thread>

namespace bem_contact::app {

namespace {

std::string digest_of(const std::string& text) {
  return sha256({std::as_bytes(std::span(text))});
}

/// Every value of every list, and all of a zip: wrong input is found before anything is computed.
void check_values(const SweepFile& sweep) {
  std::set<std::size_t> cases{0};
  if (sweep.zip)
    for (std::size_t i = 0; i < sweep.size(); ++i)
      cases.insert(i);
  std::size_t stride = sweep.size();
  for (const SweepFile::Axis& axis : sweep.axes) {
    stride /= axis.values.size();
    for (std::size_t k = 0; k < axis.values.size() && !sweep.zip; ++k)
      cases.insert(k * stride);
  }
  for (const std::size_t index : cases)
    sweep.scene(index);
}

/// The files that the cases read, each once.
std::set<std::string> inputs_of(const SweepFile& sweep) {
  std::set<std::string> names;
  for (const std::filesystem::path& file : input_files(sweep.scene(0)))
    if (std::filesystem::is_regular_file(file))
      names.insert(file.string());
  for (const SweepFile::Axis& axis : sweep.axes)
    for (const SchemaValue& value : axis.values)
      if (const auto* text = std::get_if<std::string>(&value))
        if (!text->empty() && std::filesystem::is_regular_file(sweep.folder / *text))
          names.insert((sweep.folder / *text).string());
  return names;
}

/// Of all that the results depend on.
std::string digest_of(const SweepFile& sweep, const std::string& model) {
  std::string all = provenance("bem_contact") + "\n" + model + "\n" + digest_of(sweep.text) + "\n";
  for (const std::string& name : inputs_of(sweep))
    all += digest_of(read_text_file(name, "input")) + "\n";
  return digest_of(all);
}

/// What is at the output already: nothing, or a file of this sweep.
struct Former {
  bool complete = false;
  H5Table table;
};

std::optional<Former> former_output(const std::filesystem::path& output, const std::string& digest) {
  if (!std::filesystem::exists(output))
    return std::nullopt;
  Former former;
  try {
    former.table = read_h5_top(output);
  } catch (const InputError&) {
  }
  const auto is = [&](const char* name, const std::string& value) {
    const auto at = former.table.attributes.find(name);
    return at != former.table.attributes.end() && at->second == H5Attribute(value);
  };
  if (!is("format", sweep_format) || !is("digest", digest))
    throw InputError(
        fmt::format("The output '{}' exists and is not of this sweep", output.string()),
        is("format", sweep_format)
            ? "the scene, a file that it names, --model or this program's version has changed since"
            : "it was not made by bem_contact sweep",
        "Give another output, or remove the file.");
  former.complete = former.table.attributes["missing"] == H5Attribute(0.0);
  return former;
}

CaseRecord solve_case(Sequence& sequence, const SweepFile& sweep, std::size_t index,
                      const std::string& model) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t cpu = std::clock();
  CaseRecord record;
  const auto failed = [&](CaseStatus status, const char* reason) {
    record.index = index;
    record.status = status;
    record.reason = reason;
  };
  try {
    SceneFile scene = sweep.scene(index);
    if (!model.empty())
      scene.solver.model = model_named(model);
    record = record_of(index, sequence.solve(scene), sweep.fields);
  } catch (const ConvergenceError& error) {
    failed(CaseStatus::not_certified, error.what());
  } catch (const Error& error) {
    failed(CaseStatus::refused, error.what());
  } catch (const std::exception& error) {
    failed(CaseStatus::not_certified, error.what());
  }
  record.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  record.cpu_seconds = static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC;
  return record;
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
  const auto keep = [&](const CaseRecord& record, const std::string& bytes) {
    journal.append(bytes);
    output.add(record);
    progress.step();
  };
  WorkerCalls calls;
  const auto files = std::make_shared<SequenceFiles>(); // each worker fills its own copy
  calls.make_solver = [&]() -> CaseSolver {
    const auto sequence = std::make_shared<Sequence>(SequenceOptions{}, files);
    return [&, sequence](std::size_t index) {
      return to_bytes(solve_case(*sequence, sweep, index, request.model));
    };
  };
  calls.done = [&](std::size_t, std::string bytes) { keep(from_bytes(bytes), bytes); };
  calls.died = [&](std::size_t index, const std::string& reason) {
    CaseRecord record;
    record.index = index;
    record.status = CaseStatus::died;
    record.reason = reason;
    keep(record, to_bytes(record));
  };
  const int jobs = request.jobs > 0 ? request.jobs : static_cast<int>(std::thread::hardware_concurrency());
  solve_in_processes(chunks, jobs, calls);
  progress.finish();
}

/// From the journals, case by case: fields need not fit into memory.
void write_file(const std::filesystem::path& file, const std::vector<std::filesystem::path>& journals,
                const std::string& digest, const SweepOutput& output, std::size_t cases) {
  H5Writer writer(file);
  std::vector<char> written(cases, 0);
  for (const std::filesystem::path& journal : journals)
    read_journal(journal, digest, [&](const CaseRecord& record) {
      if (record.index >= cases || std::exchange(written[record.index], 1))
        return;
      writer.add(group_of(record));
    });
  writer.add(output.top());
  writer.finish();
}

void write_csv_of(const std::filesystem::path& csv, const std::filesystem::path& file,
                  const SweepFile& sweep) {
  const H5Table table = read_h5_top(file);
  std::vector<std::string> reasons(sweep.size());
  for (std::size_t i = 0; i < sweep.size(); ++i)
    if (const auto at = table.attributes.find(fmt::format("cases/{:06}/reason", i));
        at != table.attributes.end())
      reasons[i] = std::get<std::string>(at->second);
  write_csv(csv, sweep, table, reasons);
}

/// Of the cases of a share.
SweepSummary summary_of(const H5Table& top, const Share& share, const std::string& head) {
  const std::vector<double>& status = top.datasets.at("status").values;
  const std::vector<double>& cpu = top.datasets.at("cpu_seconds").values;
  SweepSummary out;
  out.text = head;
  std::map<std::string, int> counts;
  std::size_t cases = 0;
  std::vector<double> times;
  out.certified = true;
  for (std::size_t i = 0; i < status.size(); ++i) {
    if (!belongs(i, status.size(), share))
      continue;
    const auto s = static_cast<CaseStatus>(status[i]);
    ++cases;
    ++counts[status_text(s)];
    if (!std::isnan(cpu[i]) && s != CaseStatus::died)
      times.push_back(cpu[i]);
    out.certified = out.certified && (s == CaseStatus::certified);
  }
  for (const auto& [name, number] : counts)
    out.text += fmt::format("{} {}, ", number, name);
  out.text += fmt::format("of {} cases\n", cases);
  if (!times.empty()) {
    std::ranges::sort(times);
    const auto at = [&](double quantile) {
      return times[static_cast<std::size_t>(quantile * double(times.size() - 1))];
    };
    out.text += fmt::format("CPU seconds a case: median {:.3g}, 99 % below {:.3g}, largest {:.3g}\n", at(0.5),
                            at(0.99), times.back());
  }
  return out;
}

} // namespace

SweepSummary sweep_command(const SweepRequest& request) {
  const SweepFile sweep = read_sweep_file(request.scene);
  const Share share = share_of(request.part);
  check_values(sweep);
  const std::filesystem::path output = request.output, csv = request.csv;
  std::vector<std::filesystem::path> taken{request.scene};
  for (const std::string& name : inputs_of(sweep))
    taken.push_back(name);
  const std::filesystem::path own_journal = journal_name(output, share.part, share.parts);
  for (const std::filesystem::path& file : {output, own_journal, csv}) {
    refuse_overwriting(file, taken);
    taken.push_back(file);
  }
  const std::string digest = digest_of(sweep, request.model);
  const std::optional<Former> former = former_output(output, digest);
  std::string head;
  if (former && former->complete) {
    head = fmt::format("'{}' is complete: nothing was solved\n", output.string());
    for (const std::filesystem::path& journal : journals_of(output)) // left by a kill after the file was done
      if (read_journal(journal, digest, [](const CaseRecord&) {}) > 0)
        std::filesystem::remove(journal);
  } else {
    SweepOutput results(sweep, digest);
    const auto add = [&](const CaseRecord& record) { results.add(record); };
    const auto others = [&] {
      for (const std::filesystem::path& journal : journals_of(output))
        if (request.merge || journal != own_journal)
          read_journal(journal, digest, add);
    };
    others();
    if (!request.merge) {
      SweepJournal journal(own_journal, digest, add);
      solve_missing(sweep, request, share, journal, results);
    }
    if (share.parts > 1)
      return summary_of(
          results.top(), share,
          fmt::format("share {} of {} is solved: --merge makes the file of all\n", share.part, share.parts));
    write_file(output, journals_of(output), digest, results, sweep.size());
    if (results.count(CaseStatus::missing) == 0)
      for (const std::filesystem::path& journal : journals_of(output))
        std::filesystem::remove(journal);
  }
  if (!csv.empty())
    write_csv_of(csv, output, sweep);
  return summary_of(read_h5_top(output), share, head);
}

std::string sweep_help() {
  return "The scene has a table [sweep] with lists or ranges for any of its keys:\n"
         "    [sweep]\n"
         "    position.lateral = { from = 6.2, to = 7.1, step = 0.05 }   # or count = 19\n"
         "    load.force = [ 5e4, 1e5 ]\n"
         "    mode = \"product\"        # or \"zip\"\n"
         "    fields = true           # false: keep the totals of each case only\n"
         "Called again after a kill, it goes on: SWEEP.h5.part holds what was finished.\n"
         "On a cluster (tools/cluster/slurm_sweep): sweep SCENE.toml -o SWEEP.h5 --part 1/8 ... --part 8/8,\n"
         "then sweep SCENE.toml -o SWEEP.h5 --merge.\n"
         "Exit code 0: all certified; 2: wrong input; 3: a case is missing or not certified.";
}

} // namespace bem_contact::app
