#pragma once

#include "bem_contact/base/column.hpp"
#include "bem_contact/uses/wheelset/solve_wheelset.hpp"

#include <span>

namespace bem_contact {

/// Text, JSON, HDF5 and Python take names, units and values of a wheelset from these tables. All of it is in
/// the track frame, y to the right, for both wheels: what the left wheel's own result counts to the left is
/// turned back. nan: not known.

/// One number of the wheelset.
using WheelsetQuantity = ColumnOf<WheelsetResult>;
/// All of them, in the order of the outputs.
std::span<const WheelsetQuantity> wheelset_quantities();

/// One number of each wheel. Place, inclination, radius and creepages are those of the patch that bears most.
/// Errors are those that the wheel's own result states.
struct WheelQuantity {
  const char* name;                                                ///< as outputs have it
  const char* unit;                                                ///< mm, N, MPa, rad
  const char* description;                                         ///< for readers of a file
  double (*value)(const WheelsetState&, WheelSide side);           ///< nan: not known
  double (*error)(const WheelsetState&, WheelSide side) = nullptr; ///< null: it has none
};
/// All of them, in the order of the outputs.
std::span<const WheelQuantity> wheel_quantities();

} // namespace bem_contact
