#pragma once

#include "bem_contact/base/conventions.hpp"

namespace bem_contact {

/// The middle of one row of elements. Where nothing else is said, it lies on the rail's surface (track frame;
/// a patch: its own frame, origin in the middle of the grid).
struct ContactRow {
  double s = 0;     ///< arc length along the profile, mm
  Point2 position;  ///< (y, z), mm
  double delta = 0; ///< inclination, rad
};

} // namespace bem_contact
