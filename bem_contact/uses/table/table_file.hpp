#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/uses/table/contact_table.hpp"

#include <filesystem>
#include <string>

namespace bem_contact::table {

/// What a table says at every door:
///     axes/NAME                 [n], with unit
///     first/NAME                [m + 1] of a nested axis (Axis::first), m: points of the axes before it
///     values/NAME               [n of the first axis][n of the second]..., with unit;
///                               [points] where axes are nested
///     interpolation_error/NAME  largest found in the middle of any cell, and the largest jump
///     element_error/NAME        largest stated by a point; nan: not known
///     scale/NAME                what the tolerance is relative to
///     creep_scale/log10_a_over_b, C11, C22   of a creep table
/// and axis_names (in the order of the values' dimensions), column_names, held, interpolation, tolerance,
/// points, solved, checked; of a creep table poisson, spin and symmetry. It looks into the table.
record::Record record_of(const ContactTable& table);
/// A temporary is gone before its fields are looked at.
record::Record record_of(const ContactTable&& table) = delete;

/// Writes it as HDF5, after `head`, which begins with the format (record/file_kinds.hpp).
void write_table(const std::filesystem::path& file, const record::Record& head, const ContactTable& table);

/// Returns the same numbers as plain text, for languages in which HDF5 is a burden. Blanks separate:
///     bem_contact_table 3
///     AXES COLUMNS SCALES                   (SCALES: points of the creep scale, 0 of a scene)
///     n of each axis
///     NAME 'UNIT' M, the n points, M first  (each axis; M = 0: not nested)
///     NAME 'UNIT' ERROR, then all values    (each column; ERROR: stated, Column::error())
///     log10(a/b) C11 C22                    (each point of the scale)
std::string to_text(const ContactTable& table);

/// Reads what write_table() wrote. Throws InputError for another file.
ContactTable read_table(const std::filesystem::path& file);

} // namespace bem_contact::table
