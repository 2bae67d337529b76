#pragma once

#include "bem_contact/uses/table/refine.hpp"

namespace bem_contact::table {

/// What refine() does with nested axes (Axis::first). A cell lies between neighbours of every axis; these may
/// be points of neighbouring lines. Where the middle of the cell is off, points are inserted in these lines.
/// The last axis comes first: the error of an axis can only be judged if the errors along the axes after it
/// are small. A new point of another axis gets the points of both its neighbours on the axes after it.
void refine_nested(ContactTable& table, const PointsSolver& solve, const Wanted& wanted);

} // namespace bem_contact::table
