#include "bem_contact/record/csv.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ostream>

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

void write_csv(std::ostream& out, const Table& table, int digits) {
  const char* between = "";
  for (const Column& column : table.columns)
    out << std::exchange(between, ",") << csv_name(column.name, column.unit);
  out << '\n';
  for (std::size_t row = 0; row < table.size(); ++row) {
    between = "";
    for (const Column& column : table.columns)
      out << std::exchange(between, ",") << csv_cell(column.values[row], std::min(digits, column.digits));
    out << '\n';
  }
}

} // namespace bem_contact::record
