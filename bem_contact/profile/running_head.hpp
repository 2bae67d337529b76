#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstddef>
#include <span>

namespace bem_contact {

/// Index of the highest node of the head on which wheels run, of a rail as it stands in the track: nodes
/// walked towards the field side, z down, at least one. A keeper or a check rail beside that head may be as
/// high, or higher: it is told by a groove in which a flange fits, `gauge_height` (mm) deep below the head's
/// top.
std::size_t top_of_running_head(std::span<const Point2> nodes, double gauge_height);

} // namespace bem_contact
