#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/influence/h5_table.hpp"
#include "bem_contact/sequence/scene_result.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace bem_contact {
namespace app {

enum class CaseStatus {
  missing = 0,       ///< not solved yet
  certified = 1,     ///< the certificate holds
  not_certified = 2, ///< a result whose certificate does not hold, or no convergence
  refused = 3,       ///< the input of the case is wrong: the reason says what
  died = 4           ///< the process that solved it ended
};
} // namespace app
template <> struct EnumNames<app::CaseStatus> {
  static constexpr std::array<std::string_view, 5> names{"missing", "certified", "not certified", "refused",
                                                         "died"};
};
namespace app {

/// What is kept of one case of a sweep.
struct CaseRecord {
  std::size_t index = 0;
  CaseStatus status = CaseStatus::missing;
  std::string reason;                       ///< why it is not certified; a remark of the solver, warnings
  double seconds = 0;                       ///< wall clock
  double cpu_seconds = 0;                   ///< of the process
  std::vector<double> summary;              ///< SweepColumns::cases; empty where there is no result
  std::vector<std::vector<double>> patches; ///< SweepColumns::patches of each patch
  H5Table fields;                           ///< a case of a sweep (result_file.hpp); may be empty
};

/// What stands in one column of a table.
struct Column {
  std::string name, unit, description;
};
/// The columns of both tables of a sweep.
struct SweepColumns {
  std::vector<Column> cases;
  std::vector<Column> patches; ///< empty: it has no such table
};
/// Of scenes of one contact: quantities() and patch_quantities(), errors after their numbers, and the model.
const SweepColumns& contact_columns();
/// Of scenes with [wheelset]: wheelset_quantities(), then wheel_quantities() and the model of the right wheel
/// and of the left one, as right_Fy and left_Fy.
const SweepColumns& wheelset_columns();
/// Whether a column holds a model: 0 hertz, 1 halfspace, 2 tangent_plane, 3 fem.
bool is_model(const Column& column);

/// Status, reason, quantities, patches and, with `fields`, the fields of a solved case.
CaseRecord case_record(std::size_t index, const SceneResult& result, bool fields);
/// The same of a wheelset: fields of both wheels in "right/" and "left/", each in the frame of its side.
CaseRecord case_record(std::size_t index, const WheelsetResult& result, bool fields);

/// The record as bytes (CBOR, RFC 8949) and back. Throws std::exception for bytes that are none.
std::string to_bytes(const CaseRecord& record);
CaseRecord from_bytes(std::string_view bytes);

} // namespace app
} // namespace bem_contact
