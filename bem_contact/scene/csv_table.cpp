#include "bem_contact/scene/csv_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/text_lines.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <ranges>
#include <sstream>

namespace bem_contact {

namespace {

/// A line with cells; text without its comment.
struct Line {
  int number;
  std::string text;
  std::vector<std::string> cells;
};

std::vector<Line> lines_of(const std::filesystem::path& file) {
  std::istringstream in(read_text_file(file.string(), "The table"));
  std::vector<Line> lines;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    Line line{++number, text.substr(0, text.find('#')), {}};
    std::istringstream cells(line.text);
    for (std::string cell; std::getline(cells, cell, ',');)
      line.cells.emplace_back(trimmed(cell));
    if (line.cells.size() > 1 || (line.cells.size() == 1 && !line.cells.front().empty()))
      lines.push_back(std::move(line));
  }
  return lines;
}

} // namespace

std::vector<std::string> csv_columns(const std::filesystem::path& file) {
  const std::vector<Line> lines = lines_of(file);
  if (lines.empty())
    throw InputError(fmt::format("The table '{}' is empty", file.string()), "it has no line of names",
                     "Begin it with the names of its columns.");
  return lines.front().cells;
}

std::vector<std::vector<double>> read_csv(const std::filesystem::path& file,
                                          const std::vector<std::string>& columns) {
  const std::string header = fmt::format("{}", fmt::join(columns, ", "));
  const std::vector<Line> lines = lines_of(file);
  if (!lines.empty() && lines.front().cells != columns)
    throw InputError(fmt::format("The table '{}' has other columns", file.string()),
                     fmt::format("its first line is '{}'", lines.front().text),
                     fmt::format("Begin it with '{}'.", header));
  std::vector<std::vector<double>> rows;
  for (const Line& line : lines | std::views::drop(1)) {
    std::vector<double> row;
    for (const std::string& cell : line.cells) {
      const std::optional<double> value = parse_number(cell);
      if (!value || !std::isfinite(*value))
        throw InputError(fmt::format("Line {} of the table '{}' is wrong", line.number, file.string()),
                         fmt::format("'{}' is not a finite number", cell),
                         fmt::format("Give rows of {}.", header));
      row.push_back(*value);
    }
    if (row.size() != columns.size())
      throw InputError(fmt::format("Line {} of the table '{}' is wrong", line.number, file.string()),
                       fmt::format("it has {} values", row.size()), fmt::format("Give rows of {}.", header));
    rows.push_back(std::move(row));
  }
  if (rows.empty())
    throw InputError(fmt::format("The table '{}' is empty", file.string()), "it has no row of numbers",
                     fmt::format("Give rows of {}.", header));
  return rows;
}

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(); // not given yet

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why, const std::string& give) {
  throw InputError(fmt::format("The table '{}' does not fit the grid", file.string()), why, give);
}

} // namespace

std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names) {
  std::vector<std::string> columns{"ix", "is"};
  columns.insert(columns.end(), names.begin(), names.end());
  const std::string give =
      fmt::format("Give each of ix = 0 .. {}, is = 0 .. {} once.", grid.mx - 1, grid.ms - 1);
  std::vector<std::vector<double>> fields(names.size(), std::vector<double>(grid.size(), nan));
  for (const std::vector<double>& row : read_csv(file, columns)) {
    const bool whole = row[0] == std::floor(row[0]) && row[1] == std::floor(row[1]);
    const bool inside = row[0] >= 0 && row[0] < grid.mx && row[1] >= 0 && row[1] < grid.ms;
    const std::size_t at = whole && inside ? static_cast<std::size_t>(row[1] * grid.mx + row[0]) : 0;
    if (!whole || !inside || !std::isnan(fields[0][at]))
      refuse(file,
             fmt::format("element ({}, {}) is {}", row[0], row[1],
                         whole && inside ? "given twice" : "not one of it"),
             give);
    for (std::size_t k = 0; k < names.size(); ++k)
      fields[k][at] = row[2 + k];
  }
  for (int i = 0; i < grid.size(); ++i)
    if (std::isnan(fields[0][i]))
      refuse(file, fmt::format("element ({}, {}) is missing", i % grid.mx, i / grid.mx), give);
  return fields;
}

std::vector<double> read_row_values(const std::filesystem::path& file, const ContactGrid& grid,
                                    const std::string& name) {
  const std::string give = fmt::format("Give each of is = 0 .. {} once.", grid.ms - 1);
  std::vector<double> values(grid.ms, nan);
  for (const std::vector<double>& row : read_csv(file, {"is", name})) {
    const bool known = row[0] == std::floor(row[0]) && row[0] >= 0 && row[0] < grid.ms;
    const std::size_t at = known ? static_cast<std::size_t>(row[0]) : 0;
    if (!known || !std::isnan(values[at]))
      refuse(file, fmt::format("row {} is {}", row[0], known ? "given twice" : "not one of it"), give);
    values[at] = row[1];
  }
  for (int i = 0; i < grid.ms; ++i)
    if (std::isnan(values[i]))
      refuse(file, fmt::format("row {} is missing", i), give);
  return values;
}

} // namespace bem_contact
