#pragma once

#include "bem_contact/record/column.hpp"
#include "bem_contact/sequence/result_record.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <span>

namespace bem_contact {

/// Text, JSON, HDF5 and Python take names, units and values of a wheelset from these tables. All of it is in
/// the track frame, y to the right, for both wheels: what the left wheel's own result counts to the left is
/// turned back. nan: not known.

/// One number of the wheelset.
using WheelsetQuantity = ColumnOf<WheelsetResult>;
/// Lists the numbers of a wheelset in the order of the outputs.
std::span<const WheelsetQuantity> wheelset_quantities();

/// One number of each wheel. Place, inclination, radius and creepages are those of the patch that bears most.
/// Errors are those that the wheel's own result states.
using WheelQuantity = ColumnOf<WheelsetState, WheelSide>;
/// Lists the numbers of one wheel in the order of the outputs.
std::span<const WheelQuantity> wheel_quantities();

/// What a wheelset says at every door: "wheelset/Fy", "right/track/Fy", and in "right/result" what the result
/// of this wheel says, in the frame of its side.
record::Record record_of(const WheelsetResult& result, const RecordParts& parts = {});
/// A temporary is gone before its fields are looked at.
record::Record record_of(const WheelsetResult&& result, const RecordParts& parts = {}) = delete;

} // namespace bem_contact
