#pragma once

#include "bem_contact/app/sweep_record.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// The attribute "format" of the file of a sweep.
inline constexpr const char* sweep_format = "bem_contact sweep 1";

/// The file of a sweep.
///
/// At its top: one dataset [case] for each key of the sweep (of a text: the index of its value), for status
/// (CaseStatus), seconds and cpu_seconds, and for each of summary_columns(); nan if a case has no result.
/// "cases/000012/" is the result file of case 12 (result_file.hpp). Its attribute "reason" says in words what
/// is wrong or doubtful. Attributes at the top: format, program, digest, scene, scene_text, and the number of
/// cases of each status.
class SweepOutput {
public:
  SweepOutput(const SweepFile& sweep, std::string digest);

  void add(const CaseRecord& record); ///< the first record of a case counts; its fields are not kept
  CaseStatus status(std::size_t index) const { return status_[index]; }
  std::size_t count(CaseStatus status) const;

  /// What is written at the file's top.
  H5Table top() const;

private:
  const SweepFile* sweep_;
  std::string digest_;
  std::vector<CaseStatus> status_;
  std::vector<double> seconds_, cpu_seconds_;
  std::vector<std::vector<double>> summary_;
};

/// The group of a case: its fields and its reason.
H5Table group_of(const CaseRecord& record);

/// The top of a sweep's file as CSV: case, the keys swept over, status in words, seconds, the summary,
/// reason. Throws InputError if it cannot be written.
void write_csv(const std::filesystem::path& csv, const SweepFile& sweep, const H5Table& top,
               const std::vector<std::string>& reasons);

const char* status_text(CaseStatus status);

} // namespace bem_contact::app
