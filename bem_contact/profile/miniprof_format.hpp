#pragma once

#include "bem_contact/profile/measured_points.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// Whether the text is a MiniProf file: "Key=Value" lines (.ban, .whl), sections [Profile1Info],
/// [Profile1Points] (.mpt), or the older variant that begins with "#MINIWHEELPROF" and ends its header with
/// an empty line.
bool is_miniprof(std::string_view text);

/// Its points; of a file with several profiles those of number `part`, from 1 (0: the only one). y is
/// mirrored back; z is left as it stands, because files with both signs exist. `source` names the file in
/// messages. Throws InputError for a line that is no point, another number of points than promised, and a
/// part that is not there or not said.
MeasuredPoints miniprof_points(std::string_view text, const std::string& source, int part = 0);

} // namespace bem_contact
