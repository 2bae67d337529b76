#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// What all outputs are made of. JSON, HDF5, CSV, Python and the C interface take names, units and values
/// from the tables of this header, so that a name means the same number in all of them. A number that is not
/// known, or that a result does not have, is nan (JSON: null, CSV: an empty cell, Python: None).

/// What a difference between two values of a quantity is measured by (compare_quantities.hpp).
enum class QuantityKind {
  force,
  moment,
  pressure,
  temperature,
  length,
  angle,
  area,
  creepage,
  power,
  share,
  count,
  effort ///< how the solver went: may differ where the result is the same
};

/// Unit of a quantity. What is per unit of rolled distance in rolling has another unit in a shift.
struct QuantityUnit {
  const char* rolling;         ///< in steady rolling, and of a transient
  const char* shift = nullptr; ///< null: the same

  /// That of a result.
  const char* of(const SceneResult& result) const {
    return shift && result.problem.motion == MotionKind::shift ? shift : rolling;
  }
  /// "1 (shift: mm)"
  std::string text() const {
    return shift ? std::string(rolling) + " (shift: " + shift + ")" : std::string(rolling);
  }
};

/// One number of a result. If it has an estimate of the error that the size of the elements causes
/// (Discretisation), outputs give that too, as "<name>_error" in the same unit.
struct Quantity {
  const char* name;                              ///< in all outputs
  QuantityUnit unit;                             ///< mm, N, MPa, rad
  QuantityKind kind;                             ///< for comparisons
  const char* description;                       ///< in a few words
  double (*value)(const SceneResult&);           ///< of a result
  double (*error)(const SceneResult&) = nullptr; ///< null: it has none
};
/// All of them, in the order of the outputs.
std::span<const Quantity> quantities();

/// One number of a patch.
struct PatchQuantity {
  const char* name;                                                 ///< in all outputs
  QuantityUnit unit;                                                ///< mm, N, MPa, rad
  const char* description;                                          ///< in a few words
  double (*value)(const SceneResult&, std::size_t patch);           ///< patches in the order of their forces
  double (*error)(const SceneResult&, std::size_t patch) = nullptr; ///< null: it has none
};
/// All of them, in the order of the outputs.
std::span<const PatchQuantity> patch_quantities();

/// One number of a step of a transient or of shifts.
struct StepQuantity {
  const char* name;                                               ///< in all outputs
  QuantityUnit unit;                                              ///< mm, N, MPa, rad
  const char* description;                                        ///< in a few words
  double (*value)(const SceneResult&, const ContactResult& step); ///< of one step of the history

  std::vector<double> values(const SceneResult& result) const; ///< of every step
};
/// All of them, in the order of the outputs.
std::span<const StepQuantity> step_quantities();

/// One number of each row of the grid.
struct RowQuantity {
  const char* name;                                     ///< in all outputs
  QuantityUnit unit;                                    ///< mm, N, MPa, rad
  const char* description;                              ///< in a few words
  double (*value)(const SceneResult&, std::size_t row); ///< rows in the order of the grid

  std::vector<double> values(const SceneResult& result) const; ///< of every row
};
/// All of them, in the order of the outputs.
std::span<const RowQuantity> row_quantities();

/// One number of each element. `copy` fills mx times ms numbers, [ms][mx]; 0 where a result has none.
struct ElementQuantity {
  const char* name;                                       ///< in all outputs
  QuantityUnit unit;                                      ///< mm, N, MPa, rad
  const char* description;                                ///< in a few words
  void (*copy)(const SceneResult&, std::span<double> to); ///< from a result
  /// Whether a result has it; null: every one.
  bool (*has)(const SceneResult&) = nullptr;

  bool is_in(const SceneResult& result) const { return !has || has(result); } ///< whether this result has it
  /// What `copy` gives, in a vector of its own.
  std::vector<double> values(const SceneResult& result) const;
};
/// All of them, in the order of the outputs.
std::span<const ElementQuantity> element_quantities();

/// The entry of a table with that name, which must be there.
template <class Table> constexpr const auto& named(const Table& table, std::string_view name) {
  return *std::ranges::find_if(table, [&](const auto& entry) { return name == entry.name; });
}
/// That of quantities().
inline const Quantity& quantity(std::string_view name) {
  return named(quantities(), name);
}

/// "Fx_error"
std::string error_name(const char* name);
/// What an error is, in a few words.
inline constexpr const char* error_description =
    "estimated error by the size of the elements; nan: not known";
/// Why a result has no stated errors, and what to do; "" where it has them.
std::string why_no_errors(const SceneResult& result);
/// Lists the numbers of a table, and behind each its error, if it has one: use(name, unit, value,
/// description), where `value` is the function of the quantity.
template <class Table, class Use> void with_errors(const Table& table, const Use& use) {
  for (const auto& q : table) {
    use(std::string(q.name), q.unit, q.value, q.description);
    if (q.error)
      use(error_name(q.name), q.unit, q.error, error_description);
  }
}

/// The numbers of a table in that order. `of`: what their functions take, as the result, and which patch.
template <class Table, class... Of> std::vector<double> values_of(const Table& table, const Of&... of) {
  std::vector<double> values;
  with_errors(table, [&](const std::string&, const QuantityUnit&, auto value, const char*) {
    values.push_back(value(of...));
  });
  return values;
}

/// Share of the elements in contact that adhere; 0 without contact.
double adhesion_share(const ContactResult& result);

} // namespace bem_contact
