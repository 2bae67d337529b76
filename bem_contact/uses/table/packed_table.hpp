#pragma once

#include "bem_contact/uses/table/contact_table.hpp"

#include <span>
#include <string>
#include <vector>

namespace bem_contact::table {

/// A table as conformal_packed_table.h looks it up, in some microseconds: the columns of these names in their
/// order; empty: all of them. The values are those of look_up(), and errors are Column::error(). Throws
/// InputError for a table with nested axes (of creep forces), too many axes or columns, or a name that no
/// column has.
std::vector<double> packed(const ContactTable& table, std::span<const std::string> columns = {});

/// The same as one C source without any library (C89): the functions of conformal_packed_table.h, the array
/// `conformal_packed`, and the names of its axes and columns.
std::string packed_source(const ContactTable& table, std::span<const std::string> columns = {});

/// A look-up in packed(): a value of each column, and its derivatives along the axes.
struct PackedForces {
  std::vector<double> values, errors; ///< [column], errors as stated
  std::vector<double> derivatives;    ///< [column][axis]
};
/// Looks forces up. Throws InputError outside the axes, and for another number of coordinates.
PackedForces look_up(const ContactTable& table, std::span<const double> packed, std::span<const double> at);

} // namespace bem_contact::table
