#pragma once

#include "bem_contact/app/sweep/sweep_part.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bem_contact::app {

/// Parts in the order of the sweep; a folder stands for all its files NAME.h5. Throws InputError for a file
/// that is no part of this sweep, and where two parts have the same case.
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

} // namespace bem_contact::app
