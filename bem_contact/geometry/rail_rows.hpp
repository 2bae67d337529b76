#pragma once

#include "bem_contact/geometry/placement.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// Points of the rail at the arc lengths s (mm, ascending), in the track frame.
/// Throws InputError where they leave the profile; `half_width`: of a row, mm.
std::vector<ContactRow> rail_rows(const WheelOnRail& pair, std::span<const double> s, double half_width);

/// Does the same for planar contact: points of the rail that far along the tangent at `reference`, all with
/// its inclination; s counts along the tangent from the reference point's own s. Throws InputError where the
/// rail turns away from that plane.
std::vector<ContactRow> planar_rows(const WheelOnRail& pair, std::span<const double> s,
                                    const ReferencePoint& reference);

} // namespace bem_contact
