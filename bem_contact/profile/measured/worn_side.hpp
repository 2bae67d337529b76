#pragma once

#include "bem_contact/base/conventions.hpp"

#include <span>

namespace bem_contact {

/// Returns by how much one side of a rail's head is worn beyond the other, mm: > 0: the side at y > 0; 0:
/// alike, or it cannot be told. Rails are symmetric when new. Their axis is told by the lowest parts of the
/// flanks, which no flange reaches. Points: z down, walked towards +y; heads beside a groove have no such
/// flank.
double more_worn_at_larger_y(std::span<const Point2> points);

} // namespace bem_contact
