#pragma once

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ostream>
#include <ranges>
#include <string>
#include <string_view>

/// Tables as CSV files have them: a head of names with units, then one line a row.
namespace bem_contact::app {

/// The head of a column: "Mz_Nmm" of the name "Mz" and the unit "N mm", without a unit the name alone.
inline std::string csv_name(std::string_view name, std::string_view unit) {
  std::string out(name);
  if (unit == "1")
    return out;
  out += '_';
  for (const char c : unit)
    if (c != ' ' && c != '^')
      out += c;
  return out;
}

/// A number; an empty cell for nan.
inline std::string csv_cell(double value, int digits) {
  return std::isnan(value) ? std::string() : fmt::format("{:.{}g}", value, digits);
}

/// The heads of all columns (record/column.hpp).
template <class Columns> std::string csv_head(const Columns& columns) {
  const auto name = [](const auto& column) { return csv_name(column.name, column.unit); };
  return fmt::format("{}", fmt::join(columns | std::views::transform(name), ","));
}

/// The numbers of one row. A column may have `digits` of its own.
template <class Columns, class Row>
std::string csv_line(const Columns& columns, const Row& row, int digits = 9) {
  const auto cell = [&](const auto& column) {
    if constexpr (requires { column.digits; })
      return csv_cell(column.value(row), column.digits);
    else
      return csv_cell(column.value(row), digits);
  };
  return fmt::format("{}", fmt::join(columns | std::views::transform(cell), ","));
}

/// Head and rows.
template <class Columns, class Rows>
void write_csv(std::ostream& out, const Columns& columns, const Rows& rows, int digits = 9) {
  out << csv_head(columns) << '\n';
  for (const auto& row : rows)
    out << csv_line(columns, row, digits) << '\n';
}

} // namespace bem_contact::app
