#pragma once

#include "bem_contact/uses/sweep/sweep_part.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// What is found of some neighbours in the order of a sweep, column by column: half a kilobyte a case.
struct SweepRows {
  CaseRange cases;
  std::vector<record::Outcome> status = {};        ///< [case]
  std::map<std::size_t, std::string> reasons = {}; ///< of the cases that have one, by their number
  SweepNumbers numbers = {};
};
SweepRows rows_of(CaseRange cases, std::span<const SweepCase> solved, const SweepColumns& columns);
/// The same from a part's file (read_part()). Throws InputError for a damaged one.
SweepRows read_rows(const SweepPart& part, const SweepColumns& columns);

/// Rows by the number of their first case.
using AllSweepRows = std::map<std::size_t, SweepRows>;

} // namespace bem_contact
