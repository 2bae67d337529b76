#pragma once

#include "bem_contact/base/file_lock.hpp"
#include "bem_contact/uses/sweep/sweep_join.hpp"
#include "bem_contact/uses/sweep/sweep_part.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace bem_contact::app {

/// "SWEEP.h5.parts"
std::filesystem::path parts_folder(const std::filesystem::path& output);

/// The folder of the parts of a sweep that this machine solves. One process works in it.
class PartsFolder {
public:
  /// Makes it. Throws InputError where another process works in it, or it cannot be made.
  PartsFolder(const AskedSweep& asked, const std::filesystem::path& output);
  ~PartsFolder(); ///< removes the folder if it is empty
  PartsFolder(const PartsFolder&) = delete;
  PartsFolder& operator=(const PartsFolder&) = delete;

  const AskedSweep& asked() const { return asked_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path file(std::size_t first_case) const;
  /// sorted(). Throws InputError where there are parts of another sweep.
  std::vector<SweepPart> parts() const;
  /// Removes what this class has written, with these parts (parts()), which are in the whole now.
  void clear(const std::vector<SweepPart>& parts) const;

private:
  void remove_unfinished() const;

  const AskedSweep& asked_;
  std::filesystem::path folder_;
  std::optional<LockFile> lock_;
};

/// Removes the parts of a sweep whose output will not be made any more, and nothing else that lies beside
/// them.
void remove_parts_of_sweep(const std::filesystem::path& output);

/// What was solved on this machine.
struct SolvedParts {
  DiedCases died;
  int code = 0; ///< exit code of a process that could not go on, and has said why; 0: none
};

/// Solves some cases in a child process and writes them to a file (solve_part()).
using PartSolver = std::function<void(CaseRange cases, const std::filesystem::path& file)>;
PartSolver part_solver(const AskedSweep& asked);

/// Solves in `jobs` child processes the cases that are not in a part of the folder yet; 0: one process for
/// each core.
///
/// A part is whole chunks (cut_of()): about a minute of the work that is foreseen, or less so that all
/// processes are busy to the end. The parts are taken in a fixed scrambled order, which no axis of the sweep
/// falls in step with. A part whose process died is solved again case by case: only what dies then has died.
SolvedParts solve_on_cores(const PartsFolder& folder, int jobs, const PartSolver& solver);

} // namespace bem_contact::app
