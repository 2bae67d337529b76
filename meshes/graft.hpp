#pragma once

#include "meshes/section.hpp"

#include <string>

namespace bem_contact::meshes {

/// What closes a measured profile: a blend (cubic, tangent at both ends) from its end to the body's outline
/// `base`, a closed loop; that outline; and a blend back to the profile's beginning.
/// Throws InputError, with distance and slope at both ends, if an end is farther off the outline, or more
/// inclined to it, than settings.hpp allows.
std::vector<Piece> graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name);

/// The loop turned by `angle` (rad, from +y towards +z) and then moved by `by`.
Loop placed(const Loop& loop, Point2 by, double angle);

} // namespace bem_contact::meshes
