#pragma once

#include "bem_contact/uses/sweep/sweep_part.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace bem_contact {

/// What is found where parts of a sweep should be.
struct FoundParts {
  std::vector<SweepPart> parts;                           ///< that can be joined, in the order of the sweep
  std::vector<std::filesystem::path> damaged;             ///< of the others
  std::map<std::string, std::vector<std::string>> others; ///< why they cannot be joined -> their names
  std::string first_fault;                                ///< of the first of them, as an error says it
};

/// How much of each part is read before it is joined.
enum class PartCheck { head, all };

/// The names of parts, with all files NAME.h5 of a folder in its place. Throws InputError for one that cannot
/// be read.
std::vector<std::filesystem::path> files_of_parts(const std::vector<std::filesystem::path>& names);

/// The parts among files and folders (files_of_parts()). Throws InputError where two parts have the same
/// case.
FoundParts find_parts(const AskedSweep& asked, const std::vector<std::filesystem::path>& names,
                      PartCheck check);

/// Throws InputError with the names of all that cannot be joined.
void require_parts(const FoundParts& found);

/// The parts of find_parts(). Throws what it and require_parts() do.
std::vector<SweepPart> read_parts(const AskedSweep& asked, const std::vector<std::filesystem::path>& names);

/// The cases between `parts` (read_parts()).
std::vector<CaseRange> missing_ranges(const std::vector<SweepPart>& parts, std::size_t cases);

/// Cases whose process died, and how.
using DiedCases = std::map<std::size_t, std::string>;

/// Writes the file of a sweep from its parts (read_parts()), one after the other, so that memory does not
/// grow with the sweep: its table (sweep_table.hpp), what was asked and with what (scene_record.hpp;
/// scene_with_defaults is that of the first case), and the digest and the number of cases of each status.
/// Throws InputError for a damaged part, and what H5Writer does.
void join(const AskedSweep& asked, const std::vector<SweepPart>& parts, const DiedCases& died,
          const std::filesystem::path& output);

/// Solves all cases in this process and writes the same file, without parts: for a sweep of little work.
/// `kept` is called after each case.
void solve_whole(const AskedSweep& asked, const std::filesystem::path& output,
                 const std::function<void()>& kept);

} // namespace bem_contact
