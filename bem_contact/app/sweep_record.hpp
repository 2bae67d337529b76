#pragma once

#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/scene/sweep_file.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace bem_contact::app {

enum class CaseStatus {
  missing = 0,       ///< not solved yet
  certified = 1,     ///< the certificate holds
  not_certified = 2, ///< a result whose certificate does not hold, or no convergence
  refused = 3,       ///< the input of the case is wrong: the reason says what
  died = 4           ///< the process that solved it ended
};

/// What is kept of one case of a sweep.
struct CaseRecord {
  std::size_t index = 0;
  CaseStatus status = CaseStatus::missing;
  std::string reason;          ///< why it is not certified; a remark of the solver, warnings
  double seconds = 0;          ///< wall clock
  double cpu_seconds = 0;      ///< of the process
  std::vector<double> summary; ///< summary_columns; empty where there is no result
  H5Table fields;              ///< as in a result file (result_file.hpp); may be empty
};

/// One number kept of every case.
struct SummaryColumn {
  const char *name, *unit, *description;
  double (*get)(const SceneResult&);
};
std::span<const SummaryColumn> summary_columns();

/// Status, reason, totals and, with `fields`, the result file of a solved case.
CaseRecord record_of(std::size_t index, const SceneResult& result, bool fields);

/// The record as bytes (CBOR, RFC 8949) and back. Throws std::exception for bytes that are none.
std::string to_bytes(const CaseRecord& record);
CaseRecord from_bytes(std::string_view bytes);

} // namespace bem_contact::app
