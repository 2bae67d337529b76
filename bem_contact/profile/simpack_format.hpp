#pragma once

#include "bem_contact/profile/measured_points.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <string>
#include <string_view>

namespace bem_contact {

/// Whether the text is a Simpack file (.prr, .prw).
bool is_simpack(std::string_view text);

/// Its points in mm. The format states its axes: z down, y to the field side. The flags are applied in the
/// order in which the file numbers them: 1 point.dist.min, 2 shift, 3 rotate (about x, from y towards z), 4
/// bound (where min < max), 5 mirror, 6 inversion, 7 units. Points of weight 0 do not count. `source` names
/// the file in messages. Throws InputError for a truncated file, one of the other kind, and flags that cannot
/// be honoured.
MeasuredPoints simpack_points(std::string_view text, const std::string& source, ProfileKind kind);

} // namespace bem_contact
