#pragma once

#include "bem_contact/app/sweep/sweep_part.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace bem_contact::app {

/// The names of parts, with all files NAME.h5 of a folder in its place. Throws InputError for one that cannot
/// be read.
std::vector<std::filesystem::path> files_of_parts(const std::vector<std::filesystem::path>& names);

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

} // namespace bem_contact::app
