#pragma once

#include "bem_contact/uses/table/contact_table.hpp"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bem_contact::table {

/// One coordinate for each axis.
using Point = std::vector<double>;

/// What a solution gives: a value for each column, and its error by the size of the elements (nan: unknown).
struct PointValues {
  std::vector<double> values, element_errors; ///< one for each column
};

/// Solves one point. Throws InputError for one that is refused, ConvergenceError where there is no certified
/// result.
using PointSolver = std::function<PointValues(const Point&)>;
/// Solves many, in any order; the answer has the order of the points.
using PointsSolver = std::function<std::vector<PointValues>(std::span<const Point>)>;
/// One after the other.
PointsSolver one_by_one(PointSolver solve);

/// What a table must be, and what it may cost.
struct Wanted {
  double tolerance = 0.02;          ///< largest interpolation error of each held column, over its scale
  std::size_t most_points = 200000; ///< of the table; between them about as many more are solved
  /// Sets the scales of the columns from their values; empty: they stay.
  std::function<void(ContactTable&)> rescale{};
  /// Is told how far the work is; may be empty.
  std::function<void(const std::string&)> progress{};
};

/// Solves every point of a table and, to measure the error, the middle of its cells and one more point in
/// each (nested axes: the middle alone). Where the error is too large, intervals of the axis along which it
/// is largest are halved, until all these are within the tolerance. Nested axes get points only where the
/// error is; others get them all along the table. Nothing is solved beyond the ends of the axes. Throws
/// ConvergenceError if that takes more than most_points, or if a point has no certified result.
void refine(ContactTable& table, const PointsSolver& solve, const Wanted& wanted);

} // namespace bem_contact::table
