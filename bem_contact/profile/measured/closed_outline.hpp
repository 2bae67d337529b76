#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Of the closed outline of a whole rail, leaves what is walked from foot to foot over the head, with a
/// warning that names `source`. Other points in walking order are left as they are. Throws InputError for a
/// closed outline of which the part that can touch cannot be told: a wheel, a head alone.
void open_outline(std::vector<Point2>& points, const std::string& source, ProfileKind kind);

} // namespace bem_contact
