#pragma once

#include "bem_contact/app/study/study_parts.hpp"
#include "bem_contact/base/output_folder.hpp"
#include "bem_contact/record/record.hpp"
#include "bem_contact/sequence/scene_record.hpp"

#include <span>
#include <string>
#include <vector>

namespace bem_contact::app {

/// A number of a part that people look at first.
struct HeadlineNumber {
  const Part* part = nullptr;
  std::string name, meaning, unit; ///< "right/track/pmax"
  double value = 0;
  double element_error = 0;          ///< by the size of the elements; nan: not known
  double input_spread = 0;           ///< standard deviation by [uncertainty]; nan: not drawn
  int draws = 0;                     ///< that have the number
  std::vector<double> by_state = {}; ///< for each of [uncertainty] states; nan: it has none
};

/// What a part's file says; of a sweep without the fields of its cases. Empty: it has no file.
record::Record record_of_part(const PartResult& result);

/// The headline numbers of all parts, in their order.
std::vector<HeadlineNumber> headline_of(const std::vector<PartResult>& results);

/// What study.h5 holds: the scene, what was taken, the headline as a table with its names beside it, what it
/// is for other states of the surfaces ("headline_states", [number][state]), and each part in "parts/NAME".
record::Record study_record(const GivenScene& given, const std::filesystem::path& output,
                            const std::vector<PartResult>& results,
                            const std::vector<HeadlineNumber>& headline,
                            const std::vector<std::string>& states);

/// One CSV file for each table of numbers that the parts have, study.csv with the headline, and states.csv
/// with what it is for other states of the surfaces. Returns their names.
std::vector<std::string> write_tables(OutputFolder& folder, const std::vector<PartResult>& results,
                                      const std::vector<HeadlineNumber>& headline,
                                      const std::vector<std::string>& states);

} // namespace bem_contact::app
