#pragma once

#include "bem_contact/profile/formats/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// The points of a profile file in any format that is known. `part`: which profile of a MiniProf file, from 1
/// (0: the only one). `reading`: its `mirror` chooses the left profile of a Vampire file. `source` names the
/// file in messages. Throws InputError for what cannot be read.
MeasuredPoints points_of(std::string_view text, const std::string& source, ProfileKind kind, int part,
                         const ProfileReading& reading);

/// Says whether the text is a MiniProf file: "Key=Value" lines (.ban, .whl), sections [Profile1Info],
/// [Profile1Points] (.mpt), or the older variant that begins with "#MINIWHEELPROF" or "MINIPROF" and ends its
/// header with an empty line.
bool is_miniprof(std::string_view text);
/// Its points; of a file with several profiles those of number `part`, from 1 (0: the only one). y is
/// mirrored back; z is left as it stands, because files with both signs exist. `source` names the file in
/// messages. Throws InputError for a line that is no point, another number of points than promised, and a
/// part that is not there or not said.
MeasuredPoints miniprof_points(std::string_view text, const std::string& source, int part = 0);

/// Says whether the text is a Simpack file (.prr, .prw).
bool is_simpack(std::string_view text);
/// Its points in mm. The format states its axes: z down, y to the field side. The flags are applied in the
/// order in which the file numbers them: 1 point.dist.min, 2 shift, 3 rotate (about x, from y towards z), 4
/// bound (where min < max), 5 mirror, 6 inversion, 7 units. Points of weight 0 do not count. `source` names
/// the file in messages. Throws InputError for a truncated file, one of the other kind, and flags that cannot
/// be honoured.
MeasuredPoints simpack_points(std::string_view text, const std::string& source, ProfileKind kind);

/// Says whether the text is a Vampire profile (.whe, .rai): its first line is WHEELPROFILE or RAILPROFILE.
bool is_vampire(std::string_view text);
/// The points of the right-hand profile, or with `mirror` of the left-hand one as seen from the other end.
/// The file has four columns: y and z on the left, y and z on the right, y from the track's centre. Wheel: y
/// = 0 is put at the tape circle, tape_circle outside the back of the flange (FLANGEBACK is the distance of
/// both backs); the shape decides where z points. Rail: y = 0 is put at the middle of its width, and z points
/// up.
///
/// Throws InputError for a file of the other kind, a wheel without FLANGEBACK, and a line that is no point.
MeasuredPoints vampire_points(std::string_view text, const std::string& source, ProfileKind kind,
                              const ProfileReading& reading);

} // namespace bem_contact
