#pragma once

#include <span>
#include <vector>

namespace bem_contact {

/// A column of a table: one number of each row, with the name and the unit that all outputs give it.
template <class Row> struct ColumnOf {
  const char *name, *unit, *description;
  double (*value)(const Row&); ///< nan: not known

  /// One value a row.
  std::vector<double> values(std::span<const Row> rows) const {
    std::vector<double> out;
    for (const Row& row : rows)
      out.push_back(value(row));
    return out;
  }
};

} // namespace bem_contact
