#pragma once

#include "meshes/outline_fit.hpp"

#include <string>

namespace bem_contact::meshes {

/// Lays the outline `base`, a closed loop in its own frame, on the unworn part of a measured profile. The
/// place is the one where most of the profile lies within 0.1 mm of the outline. What lies farther off counts
/// for nothing, so that wear does not pull. The search has many starts and turns the body by at most 0.1 rad.
/// Throws InputError if less than a third of the profile lies so near, if that part would slide (an arc, a
/// straight line), or if another place is nearly as good.
GraftPlace find_graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name);

} // namespace bem_contact::meshes
