#pragma once

#include "bem_contact/profile/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// Whether the text is a Vampire profile (.whe, .rai): its first line is WHEELPROFILE or RAILPROFILE.
bool is_vampire(std::string_view text);

/// The points of the right-hand profile, or of the left-hand one as seen from the other end of the vehicle.
/// The file has four columns: y and z on the left, y and z on the right, y from the track's centre. Wheel: y
/// = 0 is put at the tape circle, 70 mm outside the back of the flange (FLANGEBACK is the distance of both
/// backs); the shape decides where z points. Rail: y = 0 is put at the middle of its width, and z points up.
///
/// Throws InputError for a file of the other kind, a wheel without FLANGEBACK, and a line that is no point.
MeasuredPoints vampire_points(std::string_view text, const std::string& source, ProfileKind kind, bool left);

} // namespace bem_contact
