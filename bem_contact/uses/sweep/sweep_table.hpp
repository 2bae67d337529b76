#pragma once

#include "bem_contact/h5/table.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// Rows of a sweep that are in memory at once, as they are joined, summed up and written as CSV: some
/// megabytes.
inline constexpr std::size_t rows_at_once = rows_of_a_chunk;

/// The table of a sweep, in its file and in the files of its parts.
///
/// At the top: one dataset [case] for each key of the sweep (of a text: the index of its value), for status
/// (record::Outcome), seconds and cpu_seconds, and for each of SweepColumns::cases; nan if a case has no
/// result. The group "patches" is a table of all patches of all cases (not of wheelsets): one dataset [row]
/// for case (from 0), patch (from 1, the largest force first), each key of the sweep and each of
/// SweepColumns::patches. "cases/000012/" has the fields of case 12 (result_file.hpp). Its attribute "reason"
/// says in words what is wrong or doubtful.
H5Table table_of(const SweepFile& sweep, const SweepColumns& columns, std::span<const SweepCase> cases);

/// Cases without a result.
std::vector<SweepCase> missing_cases(CaseRange cases);

/// "cases/000012"
std::string group_of_case(std::size_t index);

/// How many cases have each status, as datasets "certified_count" ...; `status`: that of all cases.
void add_counts(H5Table& table, std::span<const std::size_t> counts);

inline constexpr const char* patch_group = "patches/";
inline constexpr const char* status_description = "0 missing, 1 certified, 2 not certified, 3 refused, 4 its "
                                                  "process died, 5 an error not foreseen; CSV: in words";
inline constexpr const char* seconds_description = "wall clock";
inline constexpr const char* cpu_description = "of its process";

/// Throws InputError unless a file has every dataset of such a table, each as long as there are cases or
/// patches. Returns how many patches there are.
std::size_t require_table(const H5Reader& file, const SweepColumns& columns, std::size_t cases);

/// Throws InputError where a number is none of first, first + 1 ... last - 1, which it stands for.
void require_within(CaseRange range, std::span<const double> values, const std::string& name,
                    const std::filesystem::path& file, bool may_be_nan = false);

/// What was solved, in how many seconds, what failed.
struct SweepSummary {
  std::string counts;     ///< "3 of 4 cases are certified; refused: 1.", a line
  std::string more;       ///< lines about warnings and seconds
  bool certified = false; ///< every case
};
/// Sums up a sweep's file, or one of a part, with so many cases.
SweepSummary sweep_summary(const H5Reader& file, std::size_t cases);

} // namespace bem_contact
