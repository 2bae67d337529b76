#include "bem_contact/app/sweep/sweep_on_cores.hpp"

#include "bem_contact/app/command.hpp"
#include "bem_contact/app/settings.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/interrupt_note.hpp"
#include "bem_contact/base/output_file.hpp"
#include "bem_contact/base/progress.hpp"
#include "bem_contact/base/said_by.hpp"
#include "bem_contact/base/workers.hpp"
#include "bem_contact/task/engine.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <fmt/format.h>
#include <map>
#include <new>
#include <numeric>
#include <ostream>
#include <random>
#include <spdlog/spdlog.h>
#include <string_view>
#include <system_error>

namespace bem_contact::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";
constexpr int out_of_memory = 64; ///< exit code of a child; none of ExitCode

/// Whether a file of the folder has a name of ours: "000012.h5".
bool is_numbered(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  return digits > 0 && name.substr(digits) == ".h5";
}

/// Or that of one that is not finished: "000012.h5.tmp77".
bool is_unfinished(const fs::path& file) {
  const std::string ending = file.extension().string();
  constexpr std::string_view begin = ".tmp";
  return is_numbered(file.stem()) && ending.starts_with(begin) && ending.size() > begin.size() &&
         ending.find_first_not_of("0123456789", begin.size()) == ending.npos;
}

/// All files there; none where it cannot be looked into.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> out;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    out.push_back(at->path());
  if (failed == std::errc::permission_denied)
    throw InputError(fmt::format("The folder '{}' cannot be read", folder.string()), failed.message(),
                     "Look at its rights, or give another output.");
  if (failed)
    throw Error(fmt::format("The folder '{}' cannot be read", folder.string()), failed.message(),
                "Look at the disk and at the limits of this process (ulimit -n).");
  return out;
}

void remove_file(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
}

bool has_bytes(const fs::path& file) {
  std::error_code unknown;
  return is_regular(file) && fs::file_size(file, unknown) > 0 && !unknown;
}

/// Always in the same order.
std::vector<std::size_t> scrambled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::shuffle(order, std::mt19937_64());
  return order;
}

/// Cases of a part. Many parts keep all processes busy to the end, and short ones cost more than they save.
std::size_t part_size(const SweepCut& cut, std::size_t cases, std::size_t jobs) {
  const double work = std::max(cut.case_work, 1.0) * double(cut.chunk),
               all = double(cases) / double(cut.chunk), of_a_process = all / double(jobs);
  const double balanced = jobs > 1 ? of_a_process / double(parts_of_a_process) : all,
               worthwhile = std::min(least_part_work / work, of_a_process),
               chunks = std::min(part_work / work, std::max(balanced, worthwhile));
  return cut.chunk * std::max<std::size_t>(1, std::lround(chunks));
}

/// In a child: says what is wrong, because nobody else can.
int exit_code_of(const std::function<void()>& work) {
  try {
    work();
    return success;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  } catch (const InputError& error) {
    spdlog::error("{}", error.what());
    return wrong_input;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return unforeseen;
  }
}

class Run {
public:
  Run(const PartsFolder& folder, int jobs, const PartSolver& solver)
      : folder_(folder), jobs_(task::processes_of(jobs)), taken_(folder.asked().sweep.size(), false),
        part_size_(part_size(cut_of(folder.asked()), taken_.size(), jobs_)), solver_(solver) {
    for (const SweepPart& part : folder_.parts())
      take(part.cases);
  }

  SolvedParts solve() {
    if (const auto open = static_cast<std::size_t>(std::ranges::count(taken_, false)); open > 0)
      solve(open);
    return std::move(out_);
  }

private:
  void solve(std::size_t open) {
    Progress progress("cases", open);
    InterruptNote note("cases", fmt::format("Give the same command again to go on: '{}' holds them.",
                                            folder_.folder().string()));
    Workers children;
    note.done(0, open);
    plan();
    for (std::size_t done = 0; out_.code == 0;) {
      while (children.size() < jobs_ && !orders_.empty()) {
        const CaseRange cases = orders_.front();
        orders_.pop_front();
        children.start(cases.first, work(cases));
        solving_[cases.first] = cases;
      }
      if (children.size() == 0)
        break;
      const std::size_t more = close(children.wait());
      progress.step(more);
      note.done(done += more, open);
    }
    if (out_.code == 0)
      progress.finish();
  }

  std::function<int()> work(CaseRange cases) const {
    return [this, cases] { return exit_code_of([&] { solver_(cases, folder_.file(cases.first)); }); };
  }

  void take(CaseRange cases) {
    std::fill(taken_.begin() + static_cast<std::ptrdiff_t>(cases.first),
              taken_.begin() + static_cast<std::ptrdiff_t>(cases.last), true);
  }

  /// Orders parts of all cases that nobody has taken.
  void plan() {
    const std::size_t cases = taken_.size();
    for (const std::size_t number : scrambled((cases + part_size_ - 1) / part_size_)) {
      const std::size_t last = std::min(cases, (number + 1) * part_size_);
      for (std::size_t i = number * part_size_; i < last; ++i) {
        if (taken_[i])
          continue;
        CaseRange run{i, i};
        while (run.last < last && !taken_[run.last])
          ++run.last;
        orders_.push_back(run);
        i = run.last;
      }
    }
  }

  /// How many cases are done with it.
  std::size_t close(const EndOfWork& end) {
    const CaseRange cases = solving_.extract(end.number).mapped();
    if (end.code == success)
      return cases_in_part(folder_.asked(), folder_.file(cases.first)).size();
    if (end.code == unforeseen || end.code == wrong_input) {
      out_.code = end.code;
      return 0;
    }
    if (cases.size() > 1) {
      order_singly(cases);
      return 0;
    }
    out_.died[cases.first] = end.code == out_of_memory ? said_by(std::bad_alloc()) : end.how;
    return 1;
  }

  void order_singly(CaseRange cases) {
    for (std::size_t i = cases.last; i > cases.first; --i)
      orders_.push_front({i - 1, i});
  }

  const PartsFolder& folder_;
  std::size_t jobs_;
  std::vector<bool> taken_; ///< cases that are in a part of a former run
  std::size_t part_size_;   ///< cases
  std::deque<CaseRange> orders_;
  std::map<std::size_t, CaseRange> solving_; ///< by the first
  const PartSolver& solver_;
  SolvedParts out_;
};

} // namespace

fs::path parts_folder(const fs::path& output) {
  return output_target(output, OutputForm::whole_file).file.string() + ".parts";
}

PartsFolder::PartsFolder(const AskedSweep& asked, const fs::path& output)
    : asked_(asked), folder_(parts_folder(output)) {
  make_folder(folder_);
  lock_.emplace(folder_ / lock_name, "Wait for it, or give another output.");
  if (!lock_->warning().empty())
    warn({lock_->warning()});
  remove_unfinished();
}

PartsFolder::~PartsFolder() {
  lock_.reset();
  std::error_code not_empty;
  fs::remove(folder_, not_empty);
}

fs::path PartsFolder::file(std::size_t first_case) const {
  return folder_ / fmt::format("{:06}.h5", first_case);
}

std::vector<SweepPart> PartsFolder::parts() const {
  std::vector<fs::path> names;
  for (const fs::path& name : files_in(folder_))
    if (is_numbered(name) && has_bytes(name)) // a crash of the machine may leave none
      names.push_back(name);
  return read_parts(asked_, names);
}

void PartsFolder::clear(const std::vector<SweepPart>& parts) const {
  for (const SweepPart& part : parts)
    remove_file(part.file);
  remove_unfinished();
}

/// What killed processes were writing: no other process works here.
void PartsFolder::remove_unfinished() const {
  for (const fs::path& file : files_in(folder_))
    if (is_unfinished(file))
      remove_file(file);
}

void remove_parts_of_sweep(const fs::path& output) {
  const fs::path folder = output.string() + ".parts";
  std::error_code unknown;
  if (!fs::is_directory(folder, unknown))
    return;
  const LockFile lock(folder / lock_name, "Wait for it, or give another output.");
  for (const fs::path& file : files_in(folder))
    if (is_unfinished(file) || (is_numbered(file) && is_part_of_sweep(file)))
      remove_file(file);
}

PartSolver part_solver(const AskedSweep& asked) {
  return [&asked](CaseRange cases, const fs::path& file) { solve_part(asked, cases, file, [] {}); };
}

SolvedParts solve_on_cores(const PartsFolder& folder, int jobs, const PartSolver& solver) {
  return Run(folder, jobs, solver).solve();
}

} // namespace bem_contact::app
