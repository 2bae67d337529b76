#pragma once

#include "bem_contact/base/column.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// What creep curves are made of. The program's outputs and Python take names, units and values from here.

/// A column of a curve, after the creepage that varies. A number that is not known is nan.
struct CreepColumn : ColumnOf<CreepPoint> {
  int digits; ///< that are worth printing
};
/// All of them, in the order of the outputs.
std::span<const CreepColumn> creep_columns();

/// The creepages of the points of a curve.
std::vector<double> creepages_of(const CreepCurve& curve);
/// The unit of a creepage.
const char* unit_of(CreepKind kind);

/// Derivatives [CreepForce][CreepKind].
struct CreepMatrixEntry {
  const char *name, *description;
  const CreepMatrix* (*of)(const CreepCurves&); ///< null: there is none
};
/// All of them, in the order of the outputs.
std::span<const CreepMatrixEntry> creep_matrices();

} // namespace bem_contact
