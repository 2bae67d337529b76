#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/uses/curves/creep_curves.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// The columns of a curve, after the creepage that varies. A number that is not known is nan.
std::span<const ColumnOf<CreepPoint>> creep_columns();
/// The unit of a creepage.
const char* unit_of(CreepKind kind);

/// What creep curves say at every door: "curves/xi" is a table; "slopes", "kalker" and "sensitivities" are
/// matrices [Fx, Fs, Mz][xi, eta, phi].
record::Record record_of(const CreepCurves& curves);
/// One curve: its creepage, then creep_columns().
record::Table table_of(const CreepCurve& curve);

} // namespace bem_contact
