#include "bem_contact/scene/case_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <sstream>

namespace bem_contact {

namespace {

constexpr std::string_view weight_column = "weight", sweep_column = "case";

struct Cell {
  std::string text;
  bool quoted = false;
};

/// Cells of a line; a doubled quote within quotes is one.
std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"' && inside && i + 1 < line.size() && line[i + 1] == '"')
      cells.back().text += line[++i];
    else if (c == '"') {
      inside = !inside;
      cells.back().quoted = true;
    } else if (c == ',' && !inside)
      cells.emplace_back();
    else
      cells.back().text += c;
  }
  for (Cell& cell : cells)
    if (!cell.quoted)
      cell.text = trimmed(cell.text);
  return cells;
}

template <class Number> std::optional<Number> number_of(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<SchemaValue> value_of(const Cell& cell) {
  if (cell.quoted)
    return cell.text;
  if (cell.text == "true" || cell.text == "false")
    return cell.text == "true";
  if (const auto whole = number_of<std::int64_t>(cell.text))
    return *whole;
  if (const auto number = number_of<double>(cell.text); number && std::isfinite(*number))
    return *number;
  return std::nullopt;
}

class CaseTableReader {
public:
  explicit CaseTableReader(std::string source) : source_(std::move(source)) {}

  void line(std::string_view text) {
    ++number_;
    if (const std::string_view content = trimmed(text); content.empty() || content.front() == '#')
      return;
    const std::vector<Cell> cells = cells_of(text);
    if (names_.empty())
      return head(cells);
    if (cells.size() != names_.size())
      refuse(fmt::format("it has {} cells, and {} columns have names", cells.size(), names_.size()),
             "Give each line one cell for each column.");
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (taken(names_[i]))
        add(names_[i], cells[i]);
  }

  CaseTable table() {
    if (table_.columns.empty())
      throw InputError(fmt::format("The table '{}' has no cases", source_),
                       "none of its columns has the name of a key of a scene",
                       "Name keys in its first line: position.lateral,load.force,motion.friction,weight.");
    if (table_.columns.front().values.empty())
      throw InputError(fmt::format("The table '{}' has no cases", source_), "it has no line below the names",
                       "Give one line a case.");
    return std::move(table_);
  }

private:
  [[noreturn]] void refuse(const std::string& why, const std::string& what_to_do) const {
    throw InputError(fmt::format("Line {} of the table '{}' is wrong", number_, source_), why, what_to_do);
  }

  /// All keys of scenes that differ from case to case have a table, so that their names have a dot.
  bool taken(const std::string& name) const {
    return names_.front() != sweep_column || name == weight_column || name.find('.') != std::string::npos;
  }

  void head(const std::vector<Cell>& cells) {
    for (const Cell& cell : cells) {
      if (std::ranges::count(names_, cell.text) > 0)
        refuse(fmt::format("two columns have the name '{}'", cell.text), "Remove one.");
      names_.push_back(cell.text);
      if (taken(cell.text) && cell.text != weight_column)
        table_.columns.push_back({cell.text, {}});
    }
  }

  void add(const std::string& name, const Cell& cell) {
    const auto value = value_of(cell);
    if (!value)
      refuse(fmt::format("'{}' is no value of {}", cell.text, name),
             "Give a finite number, true, false, or a text in quotes.");
    if (name != weight_column) {
      std::ranges::find(table_.columns, name, &CaseTable::Column::key)->values.push_back(*value);
      return;
    }
    const auto weight = number_of<double>(cell.text);
    if (!weight || *weight <= 0)
      refuse(fmt::format("the weight '{}' is not positive", cell.text), "Correct it, or remove the line.");
    table_.weights.push_back(*weight);
  }

  std::string source_;
  std::vector<std::string> names_;
  CaseTable table_;
  int number_ = 0;
};

} // namespace

CaseTable read_case_table(const std::filesystem::path& file) {
  CaseTableReader reader(file.string());
  std::istringstream in(read_text_file(file.string(), "table"));
  for (std::string line; std::getline(in, line);)
    reader.line(line);
  return reader.table();
}

} // namespace bem_contact
