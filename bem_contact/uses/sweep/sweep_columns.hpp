#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/uses/sweep/sweep_case.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// What stands in one column of a table.
struct SweepColumn {
  std::string name, unit, description;     ///< as all outputs give them
  record::Role role = record::Role::other; ///< what it is of another column
  std::string of = {};                     ///< another column, where the role asks for one
};
/// The columns of both tables of a sweep.
///
/// Of scenes of one contact: quantities() and patch_quantities(), errors after their numbers, and the model.
/// Of scenes with [wheelset]: wheelset_quantities(), then wheel_quantities() and the model of the right wheel
/// and of the left one, as right_Fy and left_Fy; and patch_quantities() with the column "left".
///
/// Where the first case names `derivatives`, each of its inputs has derived_totals() as well, as
/// Fy_by_lateral, and how far they hold: lateral_below, lateral_above. A case without such an input has nan.
struct SweepColumns {
  std::vector<SweepColumn> cases;   ///< one number a case
  std::vector<SweepColumn> patches; ///< one number a patch
  std::vector<std::string> inputs;  ///< names of those whose derivatives are columns
};
/// Of a replay, replay_columns() come after them. Reads the scene of the first case, so ask once. Throws
/// InputError where it asks for derivatives that are no columns.
SweepColumns columns_of(const SweepFile& sweep);
/// Without those of a replay.
SweepColumns columns_of_contacts(const SweepFile& sweep);
/// Says whether a column holds a model, as its number.
bool is_model(const SweepColumn& column);

/// The numbers of a result, in the order of SweepColumns::cases; `inputs`: SweepColumns has them.
std::vector<double> summary_of(const SceneResult& result, std::span<const std::string> inputs);
std::vector<double> summary_of(const WheelsetResult& result); ///< of both wheels

/// The numbers of each patch, in the order of SweepColumns::patches; the largest force first.
std::vector<std::vector<double>> patch_rows(const SceneResult& result);
std::vector<std::vector<double>> patch_rows(const WheelsetResult& result); ///< of both wheels

/// Holds both tables, column by column.
struct SweepNumbers {
  std::vector<std::vector<double>> cases;   ///< [column][case]; nan where there is no result
  std::vector<std::size_t> patch_case;      ///< [patch]: its case, from 0
  std::vector<std::size_t> patch_rank;      ///< [patch]: 1: the largest force of its case
  std::vector<std::vector<double>> patches; ///< [column][patch]
};
/// `cases`: of a sweep, in their order.
SweepNumbers numbers_of(std::span<const SweepCase> cases, const SweepColumns& columns);

} // namespace bem_contact
