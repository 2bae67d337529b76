#pragma once

#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/sweep_file.hpp"

#include <vector>

namespace bem_contact {

/// A table [passage]: places along the track at which a wheel is solved, one after the other.
///
///     [passage]
///     from = -400
///     to = 1300
///     step = 20                    # or count = 86; mm
///     path = "run.csv"             # what a vehicle program says of the wheelset on its way
///     columns = { s = "position.along", y = "position.lateral" } # as those of sweep.table
///
/// It is a list over position.along. The path has a column position.along (mm, rising or falling) and one for
/// each key that changes on the way; between its lines numbers are interpolated. Without from and to the path
/// is run from its first line to its last, without step and count at its own places. These lists go side by
/// side and change fastest.
///
/// `line`: of the table. Throws InputError naming the file's line. The path's file is added to
/// `sweep.tables`.
std::vector<SweepFile::Axis> axes_of_passage(const toml::node& passage, int line, SweepFile& sweep);

} // namespace bem_contact
