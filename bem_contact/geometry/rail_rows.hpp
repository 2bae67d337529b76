#pragma once

#include "bem_contact/geometry/placement.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"

#include <limits>
#include <span>
#include <vector>

namespace bem_contact {

/// Points of the rail at the arc lengths s (mm, ascending), in the track frame.
/// Throws InputError where they leave the profile; `half_width`: of a row, mm.
std::vector<ContactRow> rail_rows(const WheelOnRail& pair, std::span<const double> s, double half_width);

/// A plane that touches the rail. Rows lie in it up to s_to, and from there on in the next one.
struct TangentPlane {
  ReferencePoint at;                                     ///< where it touches
  double s_to = std::numeric_limits<double>::infinity(); ///< mm
};

/// Does the same for planar contact: points of the rail that far along a plane from where it touches, all
/// with its inclination; s counts along the plane from its point's own s. `planes`: ascending, one or more.
/// Throws InputError where the rail turns away from a plane.
std::vector<ContactRow> planar_rows(const WheelOnRail& pair, std::span<const double> s,
                                    std::span<const TangentPlane> planes);

} // namespace bem_contact
