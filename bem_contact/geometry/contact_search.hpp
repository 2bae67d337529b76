#pragma once

#include "bem_contact/geometry/contact_locus.hpp"
#include "bem_contact/geometry/placement.hpp"

#include <vector>

namespace bem_contact {

/// One local minimum of the vertical distance of wheel and rail (on a roller: unrolled, roller.hpp).
struct TouchPoint {
  double rail_s = 0, wheel_s = 0; ///< arc length on either profile, mm
  double x = 0;                   ///< mm
  Point2 position;                ///< on the rail, track frame
  double delta = 0;               ///< inclination of the rail there, rad
  double distance = 0;            ///< vertical distance from rail to wheel, mm (< 0: they overlap)
  /// The stretch of the rail around it within which the distance is the same to flat_distance: a point, or,
  /// where the bodies touch along a line, that line. Arc length on the rail, mm.
  double s_from = 0, s_to = 0;
  double ahead = 0; ///< by how much unevenness moves it along x, mm
};

/// Moves the wheel along z until it just touches; returns the touch points then (the first has distance 0).
/// They are all local minima of the vertical distance between the surfaces over the track's (x, y), smallest
/// first: those of the contact locus over the profile of the rail. Where a vertical line meets the rail
/// twice, the upper point counts. On a roller the distance is towards its axis, and the rest unrolled. Throws
/// InputError when no part of the wheel is above the rail, when the smallest distance is at the end of a
/// profile or of the locus (a yaw too large for so steep a flange), and if there is no touch point.
std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair);
/// Does the same with the locus of the pair, which is lowered with the wheel.
std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair, ContactLocus& locus);

} // namespace bem_contact
