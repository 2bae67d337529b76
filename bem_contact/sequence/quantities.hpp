#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// What all outputs are made of. JSON, HDF5, CSV, Python and the C interface take names, units and values
/// from the tables of this header, so that a name means the same number in all of them. A number that is not
/// known, or that a result does not have, is nan (JSON: null, CSV: an empty cell, Python: None).

/// One number of a result. If it has an estimate of the error that the size of the elements causes
/// (Measured), outputs give that too, as "<name>_error" in the same unit.
using Quantity = ColumnOf<SceneResult>;
/// Lists the numbers of a result in the order of the outputs.
std::span<const Quantity> quantities();

/// One number of a patch. Patches are in the order of their forces.
using PatchQuantity = ColumnOf<SceneResult, std::size_t>;
/// Lists the numbers of a patch in the order of the outputs.
std::span<const PatchQuantity> patch_quantities();

/// One number of a step of a transient or of shifts.
using StepQuantity = ColumnOf<SceneResult, ContactResult>;
/// Lists the numbers of a step in the order of the outputs.
std::span<const StepQuantity> step_quantities();

/// One number of each row of the grid, in its order.
using RowQuantity = ColumnOf<SceneResult, std::size_t>;
/// Lists the numbers of a row in the order of the outputs.
std::span<const RowQuantity> row_quantities();

/// One number of each element. `copy` fills mx times ms numbers, [ms][mx]; 0 where a result has none.
struct ElementQuantity {
  const char* name;                                       ///< in all outputs
  Unit unit;                                              ///< mm, N, MPa, rad
  const char* meaning;                                    ///< in a few words
  void (*copy)(const SceneResult&, std::span<double> to); ///< from a result
  /// Whether a result has it; null: every one.
  bool (*has)(const SceneResult&) = nullptr;
  /// The numbers as the result keeps them; null: they are computed.
  std::span<const double> (*stored)(const SceneResult&) = nullptr;

  bool is_in(const SceneResult& result) const { return !has || has(result); } ///< whether this result has it
  /// What `copy` gives, in a vector of its own.
  std::vector<double> values(const SceneResult& result) const;
};
/// Lists the numbers of an element in the order of the outputs.
std::span<const ElementQuantity> element_quantities();

/// Returns the quantity of that name, which must be one of quantities().
inline const Quantity& quantity(std::string_view name) {
  return named(quantities(), name);
}

/// Why a result has no stated errors, and what to do; "" where it has them.
std::string why_no_errors(const SceneResult& result);
/// Whether numbers have the units of a shift (Unit::shift).
inline bool is_shift(const SceneResult& result) {
  return result.problem.motion == MotionKind::shift;
}

} // namespace bem_contact
