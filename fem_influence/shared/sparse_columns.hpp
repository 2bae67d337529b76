#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Columns of a sparse matrix: entries column_begin[c] .. column_begin[c+1]-1, rows from 0.
struct SparseColumns {
  std::vector<std::size_t> column_begin{0};
  std::vector<int> row;
  std::vector<double> value;

  std::size_t columns() const { return column_begin.size() - 1; }
  /// An entry of the column that end_column() ends.
  void add(int to_row, double v) {
    row.push_back(to_row);
    value.push_back(v);
  }
  void end_column() { column_begin.push_back(row.size()); }
  /// use(row, value) for the entries of a column.
  template <class Use> void for_each_entry(std::size_t column, Use&& use) const {
    for (std::size_t e = column_begin[column]; e < column_begin[column + 1]; ++e)
      use(row[e], value[e]);
  }
};

/// Sums entries of a few columns: values that are added to one row and column become one entry.
class ColumnSums {
public:
  explicit ColumnSums(std::size_t columns) : entries_(columns) {}
  void add(std::size_t column, int row, double value) {
    if (value != 0)
      entries_[column][row] += value;
  }
  SparseColumns sparse() const;

private:
  std::vector<std::map<int, double>> entries_;
};

/// These columns, in this order.
SparseColumns select_columns(const SparseColumns& from, std::span<const std::size_t> columns);

/// Appends the columns of `from`, rows renumbered by `unknown`; rows that are none (-1) have a displacement
/// of zero and are left out.
void append_unknowns(SparseColumns& to, const SparseColumns& from, std::span<const int> unknown);

} // namespace bem_contact::fem
