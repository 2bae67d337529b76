#pragma once

#include "bem_contact/profile/formats/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Brings measured points into the unit, order, frame and shape that ProfileCurve::through_points() needs.
/// What it mends is listed at measured_profile(); each repair is a warning that names `source`.
/// Throws InputError where a repair would be a guess.
std::vector<Point2> repaired(MeasuredPoints measured, const std::string& source, ProfileKind kind,
                             const ProfileReading& reading = {});

} // namespace bem_contact
