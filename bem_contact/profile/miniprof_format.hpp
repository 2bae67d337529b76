#pragma once

#include "bem_contact/base/conventions.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Whether the text is a MiniProf file (.ban, .whl): "Key=Value" lines, or the older "#MINIWHEELPROF"
/// variant.
bool is_miniprof(std::string_view text);

/// Its points. y is mirrored back; z is left as it stands, because files with both signs exist. `source`
/// names the file in messages. Throws InputError for a line that is no point, or fewer points than promised.
std::vector<Point2> miniprof_points(std::string_view text, const std::string& source);

} // namespace bem_contact
