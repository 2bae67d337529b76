#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// The tip of a wheel's flange, if there is a flange: the lowest point (z down), at least 8 mm below the
/// median height and nearer to one end of the profile than to its middle.
std::optional<Point2> flange_tip(std::span<const Point2> points);

/// Moves a wheel's points along y so that y = 0 is at the tape circle: from where reading.flange_back says
/// its back is, or, with a warning, where the flange's tip is so near to y = 0 that y can only be measured
/// from the back. A flange anywhere else gives a warning, and so do a flange back that is more than 3 mm off
/// -reading.tape_circle and a height other than 0 at the tape circle. `y_sign` is that of MeasuredPoints.
/// Points are in the frame of ProfileCurve.
void set_wheel_datum(std::vector<Point2>& points, double y_sign, const std::string& source,
                     const ProfileReading& reading);

} // namespace bem_contact
