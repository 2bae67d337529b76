#pragma once

#include "bem_contact/profile/curve_piece.hpp"

#include <span>
#include <vector>

namespace bem_contact {

/// Appends the cubic spline through `points` in chord length, one polynomial piece a chord; the third
/// derivative is continuous at the points next to the ends (not-a-knot). Two points give a line, three a
/// parabola. Source: de Boor, A practical guide to splines, 1978, chapter IV.
void append_spline(std::vector<CurvePiece>& pieces, std::span<const Point2> points);

} // namespace bem_contact
