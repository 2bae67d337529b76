#pragma once

#include "bem_contact/app/sweep/sweep_record.hpp"
#include "bem_contact/uses/sweep/sweep_columns.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// The file of a sweep.
///
/// At its top: one dataset [case] for each key of the sweep (of a text: the index of its value), for status
/// (CaseStatus), seconds and cpu_seconds, and for each of SweepColumns::cases; nan if a case has no result.
/// The group "patches" is a table of all patches of all cases (not of wheelsets): one dataset [row] for case
/// (from 0), patch (from 1, the largest force first), each key of the sweep and each of
/// SweepColumns::patches. "cases/000012/" has the fields of case 12 (result_file.hpp). Its attribute "reason"
/// says in words what is wrong or doubtful. The top also says what was asked and with what (scene_record.hpp;
/// scene_with_defaults is that of the first case), and in attributes digest and the number of cases of each
/// status.
class SweepOutput {
public:
  SweepOutput(const SweepFile& sweep, const SweepColumns& columns, std::string digest);

  /// The first record of a case counts, unless its process died. Its reason is not kept.
  void add(const SweepCase& record);
  std::size_t size() const { return cases_.size(); } ///< cases
  CaseStatus status(std::size_t index) const { return cases_[index].status; }
  std::size_t count(CaseStatus status) const;
  /// False also where the process died that solved it: memory may have run out, and the next may live.
  bool finished(std::size_t index) const {
    return status(index) != CaseStatus::missing && status(index) != CaseStatus::died;
  }

  /// What is written at the file's top, but for scene and inputs.
  H5Table top() const;

private:
  void add_axes(H5Table& table, const std::string& group, const std::vector<std::size_t>& cases) const;
  void add_patches(H5Table& table, SweepNumbers& numbers) const;

  const SweepFile* sweep_;
  const SweepColumns* columns_;
  std::string digest_;
  std::vector<SweepCase> cases_; ///< without their reasons
};

/// The top of a sweep's file with its patches. Throws InputError unless it has every dataset of this sweep,
/// each as long as the sweep has cases or the file has patches.
H5Table read_sweep_top(const std::filesystem::path& file, const SweepFile& sweep,
                       const SweepColumns& columns);

/// The group of a case: its fields and its reason.
H5Table group_of(const CaseRecord& record);

/// The CSV files of a sweep. For S.csv: S_patches.csv and S_units.csv beside it; of a device or a pipe they
/// are left out ("").
struct CsvFiles {
  std::filesystem::path cases, patches, units;
};
CsvFiles csv_files(const std::filesystem::path& csv);
/// Throws InputError for a text swept over that no cell can hold so that sweep.table reads it back and a
/// spreadsheet does not compute it.
void require_csv_texts(const SweepFile& sweep);

/// The top of a sweep's file, as CSV that pandas.read_csv() takes as it is: names in the first line, then
///   cases    a line a case: case, the keys swept over, status in words, seconds, SweepColumns::cases, reason
///   patches  a line a patch: case, patch, the keys swept over, status of the case, SweepColumns::patches;
///            not of wheelsets
///   units    a line a column of either: table, name, unit, description
/// `top`: of read_sweep_top(). Throws what write_text() does (base/output_file.hpp).
void write_csv(const CsvFiles& files, const SweepFile& sweep, const SweepColumns& columns,
               const H5Table& top);

} // namespace bem_contact::app
