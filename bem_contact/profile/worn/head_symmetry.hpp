#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <optional>

namespace bem_contact {

/// The turn of a rail's head, rad, from +y towards +z, by its symmetry: heads of rails are symmetric about
/// their upright axis, whatever their standard, and below the reach of wheels they remain so. The curve is
/// laid on its mirror image with Tukey's weights, the steep sides weighing most. None if the sides are not
/// mirror images, or hardly anything between them is: two straight lines alone, as a flank and a worn gauge
/// face, are always symmetric about some axis.
std::optional<double> turn_by_symmetry(const ProfileCurve& rail);

} // namespace bem_contact
