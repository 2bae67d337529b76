#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <optional>

namespace bem_contact {

/// How a rail's head is turned.
struct HeadTurn {
  double angle = 0;   ///< rad, from +y towards +z
  bool whole = false; ///< nearly all between its sides is symmetric too: nothing tells it better
};

/// The turn of a rail's head by its symmetry: heads of rails are symmetric about
/// their upright axis, whatever their standard, and below the reach of wheels they remain so. The curve is
/// laid on its mirror image with Tukey's weights, the steep sides weighing most. None if the sides are not
/// mirror images, or hardly anything between them is: two straight lines alone, as a flank and a worn gauge
/// face, are always symmetric about some axis.
std::optional<HeadTurn> turn_by_symmetry(const ProfileCurve& rail);

} // namespace bem_contact
