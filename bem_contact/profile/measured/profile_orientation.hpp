#pragma once

#include "bem_contact/profile/formats/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <string>

namespace bem_contact {

/// Brings points that are in walking order (either way) into the frame of ProfileCurve: z down, a wheel's
/// flange at y < 0, a rail walked towards +y and a wheel towards -y.
///
/// reading.mirror and reading.profile_z come first. What they leave open is decided by the shape, with a
/// warning that names `source`, unless the format states its axes; then a shape that contradicts them gives
/// a warning. A rail that lies at y < 0 of the track's centre is mirrored.
/// Throws InputError if the shape can be read either way up, if the points of a "rail" are those of a wheel,
/// and if mirror puts a flange on the field side.
void orient(MeasuredPoints& measured, const std::string& source, ProfileKind kind,
            const ProfileReading& reading);

} // namespace bem_contact
