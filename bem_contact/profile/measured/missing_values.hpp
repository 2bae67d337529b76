#pragma once

#include "bem_contact/base/conventions.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Leaves out, with a warning that names `source`, the points that mark a missing value: a coordinate such as
/// -999, 9999.99 or 1e30, far from those of all other points; a number of nines alone that lies beyond them,
/// or "0 0", where the walk jumps there and back. Any unit. Fewer than 8 points are left as they are.
void drop_missing_values(std::vector<Point2>& points, const std::string& source);

} // namespace bem_contact
