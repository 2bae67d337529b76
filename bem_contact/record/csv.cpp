#include "bem_contact/record/csv.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <ostream>
#include <utility>

namespace bem_contact::record {

namespace {

/// With these a spreadsheet begins a formula, which it computes when the table is opened.
constexpr std::string_view begins_formula = "=+-@";

} // namespace

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

bool is_formula(std::string_view text) {
  return !text.empty() && begins_formula.find(text.front()) != begins_formula.npos;
}

std::string csv_text(std::string_view text) {
  std::string out(is_formula(text) ? "\" " : "\"");
  for (const char c : text) {
    out.append(c == '"' ? 1 : 0, '"');
    out.push_back(c == '\n' || c == '\r' ? ' ' : c);
  }
  out.push_back('"');
  return out;
}

void require_cell(std::string_view name, std::string_view what) {
  const auto is_control = [](unsigned char c) { return std::iscntrl(c) != 0; };
  if (!is_formula(name) && std::ranges::none_of(name, is_control))
    return;
  throw InputError(fmt::format("{} = {} cannot be a cell of --csv", what, toml_text(name)),
                   is_formula(name) ? "a spreadsheet takes what begins with = + - @ as a formula"
                                    : "tables have one line for each row",
                   "Give the file another name, or leave out --csv.");
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
