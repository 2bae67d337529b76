#pragma once

#include "meshes/section.hpp"

#include <string>

namespace bem_contact::meshes {

/// How far a measured profile may lie off the body it is grafted onto.
struct GraftLimits {
  double distance = 2; ///< of its ends from the body's outline, mm
  double slope =
      0.7; ///< between the two tangents there, rad (a flank that ends beside the under-head fillet)
  double shortest_blend = 4; ///< mm of the body's outline that a blend replaces, at least
  double blend_ratio = 5;    ///< and at least this many times the distance
  double area = 0.3;         ///< change of the section's area, of itself
};

/// What closes a measured profile: from its end a blend (cubic, tangent at both ends) to the body's outline
/// `base`, a closed loop, along that outline, and a blend back to the profile's beginning.
/// Throws InputError, with distance and slope at both ends, where a limit is passed.
std::vector<Piece> graft(const ProfileCurve& measured, const Loop& base, const std::string& base_name,
                         const GraftLimits& limits = {});

/// The loop turned by `angle` (rad, from +y towards +z) and then moved by `by`.
Loop placed(const Loop& loop, Point2 by, double angle);

} // namespace bem_contact::meshes
