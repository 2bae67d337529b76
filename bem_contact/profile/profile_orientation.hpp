#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Brings points that are in walking order (either way) into the frame of ProfileCurve: z down, a wheel's
/// flange at y < 0, a rail walked towards +y and a wheel towards -y. Each change of sign is a warning that
/// names `source`. Throws InputError if the points of a "rail" are those of a wheel.
void orient(std::vector<Point2>& points, const std::string& source, ProfileKind kind);

} // namespace bem_contact
