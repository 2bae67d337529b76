#include "fem_influence/shared/sparse_columns.hpp"

namespace bem_contact::fem {

SparseColumns ColumnSums::sparse() const {
  SparseColumns out;
  for (const auto& column : entries_) {
    for (const auto& [row, value] : column)
      out.add(row, value);
    out.end_column();
  }
  return out;
}

SparseColumns select_columns(const SparseColumns& from, std::span<const std::size_t> columns) {
  SparseColumns some;
  for (const std::size_t c : columns) {
    from.for_each_entry(c, [&](int row, double value) { some.add(row, value); });
    some.end_column();
  }
  return some;
}

void append_unknowns(SparseColumns& to, const SparseColumns& from, std::span<const int> unknown) {
  for (std::size_t c = 0; c < from.columns(); ++c) {
    from.for_each_entry(c, [&](int row, double value) {
      if (const int u = unknown[static_cast<std::size_t>(row)]; u >= 0)
        to.add(u, value);
    });
    to.end_column();
  }
}

} // namespace bem_contact::fem
