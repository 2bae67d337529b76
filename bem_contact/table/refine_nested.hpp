#pragma once

#include "bem_contact/table/refine.hpp"

namespace bem_contact::table {

/// What refine() does with nested axes (Axis::first). A cell lies between neighbours of every axis, which may
/// be points of lines beside each other. Where its middle is off, points are inserted in these lines: first
/// on the last axis, for on the others an error counts as theirs alone if those on the axes after them are
/// small. What lies below a new point of another axis is what both of its neighbours have.
void refine_nested(ContactTable& table, const PointsSolver& solve, const Wanted& wanted);

} // namespace bem_contact::table
