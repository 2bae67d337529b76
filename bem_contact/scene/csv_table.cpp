#include "bem_contact/scene/csv_table.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <span>
#include <sstream>

namespace bem_contact {

namespace {

/// Cells of a line; a doubled quote within quotes is one. A comment ends the line.
std::vector<CsvCell> cells_of(std::string_view line) {
  std::vector<CsvCell> cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size() && (inside || line[i] != '#'); ++i) {
    const char c = line[i];
    CsvCell& cell = cells.back();
    if (c == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
      cell.text += line[++i];
    else if (c == '"') {
      if (!inside)
        cell.text = trimmed(cell.text); // no blanks before the quotes
      inside = !inside;
      cell.quoted = true;
    } else if (c == ',' && !inside)
      cells.emplace_back();
    else if (inside || !cell.quoted || !trimmed({&c, 1}).empty()) // nor those behind them
      cell.text += c;
  }
  for (CsvCell& cell : cells)
    if (!cell.quoted)
      cell.text = trimmed(cell.text);
  return cells;
}

/// Of a table of numbers: a comma may end a line.
std::vector<CsvLine> lines_of_numbers(const std::filesystem::path& file) {
  std::vector<CsvLine> lines = csv_lines(file);
  for (CsvLine& line : lines)
    if (line.cells.size() > 1 && line.cells.back().text.empty())
      line.cells.pop_back();
  return lines;
}

/// Outside quotes.
bool has_semicolon(const CsvLine& line) {
  return std::ranges::any_of(line.cells, [](const CsvCell& cell) {
    return !cell.quoted && cell.text.find(';') != std::string::npos;
  });
}

std::vector<std::string> texts_of(const CsvLine& line) {
  std::vector<std::string> texts;
  for (const CsvCell& cell : line.cells)
    texts.push_back(cell.text);
  return texts;
}

} // namespace

std::vector<CsvLine> csv_lines(const std::filesystem::path& file) {
  std::istringstream in(read_text_file(file.string(), "The table"));
  std::vector<CsvLine> lines;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    CsvLine line{++number, cells_of(text)};
    if (line.cells.size() > 1 || !line.cells.front().text.empty())
      lines.push_back(std::move(line));
  }
  if (!lines.empty() && has_semicolon(lines.front()))
    refuse_line(file, lines.front(), "semicolons separate its names",
                "Separate cells by commas, and write numbers with a decimal point.");
  return lines;
}

void refuse_line(const std::filesystem::path& file, const CsvLine& line, const std::string& why,
                 const std::string& what_to_do) {
  throw InputError(fmt::format("Line {} of the table '{}' is wrong", line.number, file.string()), why,
                   what_to_do);
}

void require_cells(const std::filesystem::path& file, const CsvLine& line, std::size_t columns) {
  if (line.cells.size() == columns)
    return;
  const std::string why = fmt::format("it has {}, and {}", counted(line.cells.size(), "cell", "cells"),
                                      counted(columns, "column has a name", "columns have names"));
  const std::string give = "Give each line one cell for each column";
  if (has_semicolon(line))
    refuse_line(file, line, why, give + ", separated by commas, not semicolons.");
  if (line.cells.size() > columns)
    refuse_line(file, line, why, give + "; numbers have a decimal point, because a comma separates cells.");
  refuse_line(file, line, why, give + ".");
}

std::vector<std::string> csv_columns(const std::filesystem::path& file) {
  const std::vector<CsvLine> lines = lines_of_numbers(file);
  if (lines.empty())
    throw InputError(fmt::format("The table '{}' is empty", file.string()), "it has no line of names",
                     "Begin it with the names of its columns.");
  return texts_of(lines.front());
}

std::vector<std::vector<double>> read_csv(const std::filesystem::path& file,
                                          const std::vector<std::string>& columns) {
  const std::string header = fmt::format("{}", fmt::join(columns, ", "));
  const std::string give = fmt::format("Give rows of {}.", header);
  const std::vector<CsvLine> lines = lines_of_numbers(file);
  if (!lines.empty() && texts_of(lines.front()) != columns)
    throw InputError(fmt::format("The table '{}' has other columns", file.string()),
                     fmt::format("its first line is '{}'", fmt::join(texts_of(lines.front()), ", ")),
                     fmt::format("Begin it with '{}'.", header));
  std::vector<std::vector<double>> rows;
  for (const CsvLine& line : std::span(lines).subspan(std::min<std::size_t>(1, lines.size()))) {
    require_cells(file, line, columns.size());
    std::vector<double> row;
    for (const CsvCell& cell : line.cells) {
      const std::optional<double> value = parse_number(cell.text);
      if (!value || !std::isfinite(*value))
        refuse_line(file, line, fmt::format("'{}' is not a finite number", cell.text), give);
      row.push_back(*value);
    }
    rows.push_back(std::move(row));
  }
  if (rows.empty())
    throw InputError(fmt::format("The table '{}' is empty", file.string()), "it has no row of numbers", give);
  return rows;
}

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(); // not given yet

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why, const std::string& give) {
  throw InputError(fmt::format("The table '{}' does not fit the grid", file.string()), why, give);
}

/// `by_row`: without the column ix, one value for each row.
std::vector<std::vector<double>> read_once_each(const std::filesystem::path& file, const ContactGrid& grid,
                                                const std::vector<std::string>& names, bool by_row) {
  const int mx = by_row ? 1 : grid.mx;
  std::vector<std::string> columns =
      by_row ? std::vector<std::string>{"is"} : std::vector<std::string>{"ix", "is"};
  const std::size_t first = columns.size();
  columns.insert(columns.end(), names.begin(), names.end());
  const std::string give = fmt::format("Give each of {}is = 0 .. {} once.",
                                       by_row ? "" : fmt::format("ix = 0 .. {}, ", mx - 1), grid.ms - 1);
  const auto named = [&](double ix, double is) {
    return by_row ? fmt::format("row {}", is) : fmt::format("element ({}, {})", ix, is);
  };
  std::vector<std::vector<double>> fields(names.size(), std::vector<double>(mx * grid.ms, nan));
  for (const std::vector<double>& row : read_csv(file, columns)) {
    const double ix = by_row ? 0 : row[0], is = row[first - 1];
    const bool known =
        ix == std::floor(ix) && is == std::floor(is) && ix >= 0 && ix < mx && is >= 0 && is < grid.ms;
    const std::size_t at = known ? static_cast<std::size_t>(is * mx + ix) : 0;
    if (!known || !std::isnan(fields[0][at]))
      refuse(file, fmt::format("{} is {}", named(ix, is), known ? "given twice" : "not one of it"), give);
    for (std::size_t k = 0; k < names.size(); ++k)
      fields[k][at] = row[first + k];
  }
  for (int i = 0; i < mx * grid.ms; ++i)
    if (std::isnan(fields[0][i]))
      refuse(file, fmt::format("{} is missing", named(i % mx, i / mx)), give);
  return fields;
}

} // namespace

std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names) {
  return read_once_each(file, grid, names, false);
}

std::vector<double> read_row_values(const std::filesystem::path& file, const ContactGrid& grid,
                                    const std::string& name) {
  return read_once_each(file, grid, {name}, true).front();
}

} // namespace bem_contact
