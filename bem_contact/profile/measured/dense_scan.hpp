#pragma once

#include "bem_contact/base/conventions.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// A laser scan whose points scatter by more than they are apart runs back and forth all along. Replaces
/// points in walking order by the means of neighbours, as few as bring them into order, with a warning that
/// names `source`. False, and nothing is changed, where means at most 1 mm apart do not: then it is no
/// scatter.
bool thin_scan(std::vector<Point2>& points, const std::string& source);

} // namespace bem_contact
