#pragma once

#include "meshes/section.hpp"

#include <string>

namespace bem_contact::meshes {

/// Where a standard body lies in the frame of a measured profile: turned by `angle` (rad, from +y towards
/// +z), then its origin moved to `at`, mm.
struct GraftPlace {
  Point2 at;
  double angle = 0;
  double share = 0; ///< of the profile that lies on the body there, see below
};

/// Lays the outline `base`, a closed loop in its own frame, on the unworn part of a measured profile: the
/// place where most of the profile lies within 0.1 mm of it (what lies farther off counts for nothing, so
/// that wear does not pull), found from many starts, turned by at most 0.1 rad. Throws InputError where less
/// than a third of the profile does, where that part would slide (an arc, a straight line), or where another
/// place is nearly as good.
GraftPlace find_graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name);

} // namespace bem_contact::meshes
