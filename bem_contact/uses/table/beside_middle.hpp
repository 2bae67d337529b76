#pragma once

#include "bem_contact/uses/table/refine.hpp"

#include <vector>

namespace bem_contact::table {

/// How far the interpolation along one axis may be off a quarter of the way into a cell, where its middle
/// tells nothing: of each column, in its unit.
///
/// Between two points the interpolation has the slopes of parabolas. Where the function is like a cubic, the
/// slopes at both ends are off by the same amount. In the middle this cancels, and the interpolation is as
/// good there as a cubic through four points; a fifth of the interval away from the ends it is off most. The
/// cubic through the four points around the cell tells by how much: no further solution is needed. What both
/// differ by in the middle is left out. Nothing (0) in the first and the last interval, whose parabola is off
/// most near the middle, of nested axes, and of an axis with fewer points.
std::vector<double> beside_middle(const ContactTable& table, const Point& middle, std::size_t axis);

/// The largest error in a cell, by that in its middle and those beside it along all axes.
double in_cell(double in_middle, double beside);

} // namespace bem_contact::table
