#include "bem_contact/scene/case_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <optional>
#include <span>

namespace bem_contact {

namespace {

constexpr std::string_view weight_column = "weight", sweep_column = "case", note = "note";

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

/// The first line with the names that `renamed` gives.
CsvLine renamed_head(const std::filesystem::path& file, CsvLine head,
                     const std::map<std::string, std::string>& renamed) {
  for (const auto& [name, meaning] : renamed) {
    const auto cell = std::ranges::find(head.cells, name, &CsvCell::text);
    if (cell == head.cells.end()) {
      std::vector<std::string> names;
      std::ranges::transform(head.cells, std::back_inserter(names), &CsvCell::text);
      refuse_line(file, head,
                  fmt::format("no column has the name '{}', which the scene says what it is", name),
                  fmt::format("Its columns are {}.", fmt::join(names, ", ")));
    }
    cell->text = meaning == note ? std::string(CaseTable::Column::note_prefix) + name : meaning;
  }
  return head;
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
  table.lines.push_back(line.number);
  for (std::size_t i = 0; i < line.cells.size(); ++i) {
    const std::string &name = head.cells[i].text, &text = line.cells[i].text;
    const auto column = std::ranges::find(table.columns, name, &CaseTable::Column::key);
    if (column == table.columns.end() && name != weight_column)
      continue;
    if (column != table.columns.end() && column->is_note()) { // of any text
      column->values.emplace_back(text);
      continue;
    }
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

namespace {

/// Notes are numbers where all of them are.
void take_numbers(CaseTable::Column& column) {
  std::vector<SchemaValue> numbers;
  for (const SchemaValue& text : column.values)
    if (const auto number = parse_number(std::get<std::string>(text)); number && std::isfinite(*number))
      numbers.emplace_back(*number);
  if (numbers.size() == column.values.size())
    column.values = std::move(numbers);
}

} // namespace

CaseTable read_case_table(const std::filesystem::path& file,
                          const std::map<std::string, std::string>& renamed) {
  const auto refuse = [&](const char* why, const char* what_to_do) {
    throw InputError(fmt::format("The table '{}' has no cases", file.string()), why, what_to_do);
  };
  const std::vector<CsvLine> lines = csv_lines(file);
  const CsvLine head = lines.empty() ? CsvLine{} : renamed_head(file, lines.front(), renamed);
  CaseTable table = lines.empty() ? CaseTable{} : columns_of(file, head);
  if (std::ranges::all_of(table.columns, &CaseTable::Column::is_note))
    refuse("none of its columns has the name of a key of a scene",
           "Name keys in its first line: position.lateral,load.force,motion.friction,weight.");
  if (lines.size() == 1)
    refuse("it has no line below the names", "Give one line a case.");
  for (const CsvLine& line : std::span(lines).subspan(1))
    add_case(file, head, line, table);
  for (CaseTable::Column& column : table.columns)
    if (column.is_note())
      take_numbers(column);
  return table;
}

} // namespace bem_contact
