#include "bem_contact/scene/case_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <ranges>

namespace bem_contact {

namespace {

constexpr std::string_view weight_column = "weight", sweep_column = "case";

std::optional<SchemaValue> value_of(const CsvCell& cell) {
  const std::string& text = cell.text;
  if (cell.quoted)
    return text;
  if (text == "true" || text == "false")
    return text == "true";
  std::int64_t whole = 0;
  if (const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), whole);
      error == std::errc() && end == text.data() + text.size())
    return whole;
  if (const auto number = parse_number(text); number && std::isfinite(*number))
    return *number;
  return std::nullopt;
}

/// The columns that are taken. All keys of scenes that differ from case to case have a table, so that their
/// names have a dot.
CaseTable columns_of(const std::filesystem::path& file, const CsvLine& head) {
  CaseTable table;
  for (const CsvCell& cell : head.cells) {
    const std::string& name = cell.text;
    if (std::ranges::count(head.cells, name, &CsvCell::text) > 1)
      refuse_line(file, head, fmt::format("two columns have the name '{}'", name), "Remove one.");
    const bool of_sweep = head.cells.front().text == sweep_column;
    if (name != weight_column && (!of_sweep || name.find('.') != std::string::npos))
      table.columns.push_back({name, {}});
  }
  return table;
}

void add_case(const std::filesystem::path& file, const CsvLine& head, const CsvLine& line, CaseTable& table) {
  require_cells(file, line, head.cells.size());
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    const std::string &name = head.cells[i].text, &text = line.cells[i].text;
    const auto column = std::ranges::find(table.columns, name, &CaseTable::Column::key);
    if (column == table.columns.end() && name != weight_column)
      continue;
    const auto value = value_of(line.cells[i]);
    if (!value)
      refuse_line(file, line, fmt::format("'{}' is no value of {}", text, name),
                  "Give a finite number, true, false, or a text in quotes.");
    if (column != table.columns.end()) {
      column->values.push_back(*value);
      continue;
    }
    const auto weight = parse_number(text);
    if (!weight || *weight <= 0)
      refuse_line(file, line, fmt::format("the weight '{}' is not positive", text),
                  "Correct it, or remove the line.");
    table.weights.push_back(*weight);
  }
}

} // namespace

CaseTable read_case_table(const std::filesystem::path& file) {
  const auto refuse = [&](const char* why, const char* what_to_do) {
    throw InputError(fmt::format("The table '{}' has no cases", file.string()), why, what_to_do);
  };
  const std::vector<CsvLine> lines = csv_lines(file);
  CaseTable table = lines.empty() ? CaseTable{} : columns_of(file, lines.front());
  if (table.columns.empty())
    refuse("none of its columns has the name of a key of a scene",
           "Name keys in its first line: position.lateral,load.force,motion.friction,weight.");
  if (lines.size() == 1)
    refuse("it has no line below the names", "Give one line a case.");
  for (const CsvLine& line : lines | std::views::drop(1))
    add_case(file, lines.front(), line, table);
  return table;
}

} // namespace bem_contact
