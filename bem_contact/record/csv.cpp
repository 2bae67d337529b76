#include "bem_contact/record/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <utility>

namespace bem_contact::record {

std::string csv_name(std::string_view name, std::string_view unit) {
  std::string out(name);
  if (unit == "1")
    return out;
  out += '_';
  for (const char c : unit)
    if (c != ' ' && c != '^')
      out += c;
  return out;
}

std::string csv_cell(double value, int digits) {
  return std::isnan(value) ? std::string() : fmt::format("{:.{}g}", value, digits);
}

std::string csv_head(const Table& table) {
  std::string out;
  for (const Column& column : table.columns)
    out += (out.empty() ? "" : ",") + csv_name(column.name, column.unit);
  return out;
}

std::string csv_line(const Table& table, std::size_t row, int digits) {
  std::string out;
  const char* between = "";
  for (const Column& column : table.columns)
    out.append(std::exchange(between, ","))
        .append(csv_cell(column.values[row], std::min(digits, column.digits)));
  return out;
}

void write_csv(std::ostream& out, const Table& table, int digits) {
  out << csv_head(table) << '\n';
  for (std::size_t row = 0; row < table.size(); ++row)
    out << csv_line(table, row, digits) << '\n';
}

} // namespace bem_contact::record
