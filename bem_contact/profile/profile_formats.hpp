#pragma once

#include "bem_contact/profile/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// The points of a profile file in any format that is known. `part`: which profile of a MiniProf file, from 1
/// (0: the only one); `left`: of a Vampire file. `source` names the file in messages. Throws InputError for
/// what cannot be read.
MeasuredPoints points_of(std::string_view text, const std::string& source, ProfileKind kind, int part,
                         bool left);

} // namespace bem_contact
