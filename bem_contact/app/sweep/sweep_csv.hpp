#pragma once

#include "bem_contact/h5/table.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include <filesystem>

namespace bem_contact::app {

/// How the tables of patches and of units begin, by which one of a former run is known.
inline constexpr const char *patches_begin = "case,patch", *units_begin = "table,name,unit,description\n";

/// The CSV files of a sweep. For S.csv: S_patches.csv and S_units.csv beside it; of a device or a pipe they
/// are left out ("").
struct CsvFiles {
  std::filesystem::path cases, patches, units;
};
CsvFiles csv_files(const std::filesystem::path& csv);
/// Throws InputError for a text swept over that no cell can hold so that sweep.table reads it back and a
/// spreadsheet does not compute it.
void require_csv_texts(const SweepFile& sweep);

/// A sweep's file, as CSV that pandas.read_csv() takes as it is: names in the first line, then
///   cases    a line a case: case, the keys swept over, status in words, seconds, SweepColumns::cases, reason
///   patches  a line a patch: case, patch, the keys swept over, status of the case, SweepColumns::patches;
///            not of wheelsets
///   units    a line a column of either: table, name, unit, description
/// `file` has the table of the sweep (require_table()). Throws what write_text() does (base/output_file.hpp),
/// and InputError for a number that stands for no word.
void write_csv(const CsvFiles& files, const SweepFile& sweep, const SweepColumns& columns,
               const H5Reader& file);

} // namespace bem_contact::app
