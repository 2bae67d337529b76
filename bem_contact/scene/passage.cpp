#include "bem_contact/scene/passage.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/value_range.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

constexpr const char* along = "position.along";

/// Nothing of a text or a flag.
std::optional<double> number_in(const SchemaValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    return static_cast<double>(*whole);
  const auto* number = std::get_if<double>(&value);
  return number ? std::optional(*number) : std::nullopt;
}

/// What a vehicle program says of the wheelset's way, ordered by rising place.
class Path {
public:
  Path(std::filesystem::path file, const std::map<std::string, std::string>& renamed)
      : file_(std::move(file)), table_(read_case_table(file_, renamed)) {
    if (!table_.weights.empty())
      throw InputError(fmt::format("'{}' has weights", file_.string()),
                       "the places of a passage occur as often as each other", "Leave out that column.");
    const auto places = std::ranges::find(table_.columns, along, &CaseTable::Column::key);
    if (places == table_.columns.end())
      refuse_without_places();
    at_ = numbers_of(*places);
    table_.columns.erase(places);
    falls_ = at_.size() > 1 && at_.back() < at_.front();
    if (falls_)
      reverse();
    for (std::size_t i = 1; i < at_.size(); ++i)
      if (!(at_[i] > at_[i - 1]))
        throw InputError(
            fmt::format("{}:{}: the wheelset stands still or turns back", file_.string(), table_.lines[i]),
            fmt::format("{} is {:g} mm there and {:g} mm in the line before", along, at_[i], at_[i - 1]),
            "Give a path whose places all rise or all fall.");
  }

  double begins() const { return falls_ ? at_.back() : at_.front(); } ///< mm
  double ends() const { return falls_ ? at_.front() : at_.back(); }
  std::vector<SchemaValue> own_places() const {
    std::vector<SchemaValue> out(at_.begin(), at_.end());
    if (falls_)
      std::ranges::reverse(out);
    return out;
  }
  const std::filesystem::path& file() const { return file_; }

  /// All columns at these places, each beside position.along.
  void add_axes(const std::vector<SchemaValue>& places, int line, std::vector<SweepFile::Axis>& axes) const {
    std::vector<PlaceInTable> found;
    for (const SchemaValue& place : places)
      found.push_back(place_of(number_in(place).value_or(0)));
    for (const CaseTable::Column& column : table_.columns) {
      if (column.is_note())
        continue; // a text has nothing between its lines
      const std::vector<double> numbers = numbers_of(column);
      SweepFile::Axis axis{column.key, {}, line, false, true, file_.string()};
      for (const auto& [before, share] : found) {
        const double next = before + 1 < numbers.size() ? numbers[before + 1] : numbers[before];
        axis.values.emplace_back(numbers[before] + share * (next - numbers[before]));
        axis.lines.push_back(table_.lines[before]);
      }
      axes.push_back(std::move(axis));
    }
  }

private:
  [[noreturn]] void refuse_without_places() const {
    const std::vector<std::string> others = keys_of_table("position"); // these mean something else
    std::vector<std::string> names;
    for (const CaseTable::Column& column : table_.columns)
      if (!column.key.starts_with("position.") ||
          std::ranges::find(others, column.key.substr(9)) == others.end())
        names.push_back(column.key);
    const auto like = nearest_names(along, names, 1);
    throw InputError(
        fmt::format("'{}' has no column {}", file_.string(), along),
        "a passage finds the wheelset by its place along the track",
        like.empty()
            ? fmt::format("Add it, in mm, or say which it is: passage.columns = {{ s = \"{}\" }}.", along)
            : fmt::format("Is it the column {}? Call it {}.", like[0], along));
  }
  void reverse() {
    std::ranges::reverse(at_);
    std::ranges::reverse(table_.lines);
    for (CaseTable::Column& column : table_.columns)
      std::ranges::reverse(column.values);
  }
  std::vector<double> numbers_of(const CaseTable::Column& column) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < column.values.size(); ++i) {
      const auto number = number_in(column.values[i]);
      if (!number)
        throw InputError(
            fmt::format("{}:{}: column {} is no number", file_.string(), table_.lines[i], column.key),
            "between the lines of a path numbers are interpolated",
            "Give numbers, or set the key in the scene.");
      out.push_back(*number);
    }
    return out;
  }
  PlaceInTable place_of(double place) const {
    if (place < at_.front() || place > at_.back())
      throw InputError(
          fmt::format("The passage is at {:g} mm, and '{}' says nothing of it", place, file_.string()),
          fmt::format("the path goes from {:g} to {:g} mm", at_.front(), at_.back()),
          "Give passage.from and passage.to within it.");
    return {at_, place};
  }

  std::filesystem::path file_;
  CaseTable table_;
  std::vector<double> at_; ///< mm
  bool falls_ = false;
};

/// passage.columns
std::map<std::string, std::string> renamed_columns(const toml::table& passage, const std::string& where) {
  std::map<std::string, std::string> out;
  const toml::node* node = passage.get("columns");
  if (!node)
    return out;
  const toml::table* names = node->as_table();
  if (!names || !std::ranges::all_of(*names, [](const auto& one) { return one.second.is_string(); }))
    throw InputError(where + "passage.columns cannot be that",
                     "it says of columns of the path which key each is",
                     "Give for instance columns = { s = \"position.along\", y = \"position.lateral\" }.");
  for (const auto& [name, meaning] : *names)
    out.emplace(name.str(), meaning.value_or(std::string()));
  return out;
}

/// from, to, step or count; none where none of them is given. A path is run from end to end.
std::vector<SchemaValue> given_places(const toml::table& passage, const std::optional<Path>& path,
                                      const std::string& where) {
  toml::table ends;
  for (const char* key : {"from", "to", "step", "count"})
    if (const toml::node* value = passage.get(key))
      ends.insert(key, *value);
  if (ends.empty())
    return {};
  if (path && !ends.contains("from") && !ends.contains("to")) {
    ends.insert("from", path->begins());
    ends.insert("to", path->ends());
  }
  return values_of_range(ends, "passage", where);
}

} // namespace

std::vector<SweepFile::Axis> axes_of_passage(const toml::node& node, int line, SweepFile& sweep) {
  const std::string where = fmt::format("{}:{}: ", sweep.text.source, line);
  if (!node.is_table())
    throw InputError(where + "passage is no table",
                     "it says from where to where and by which steps a wheel goes",
                     "Give [passage] with from, to and step in mm below it.");
  const toml::table& passage = *node.as_table();
  require_known_options(passage, "passage", sweep.text.source);
  std::optional<Path> path;
  if (const toml::node* file = passage.get("path")) {
    const std::string name = file->value_or(std::string());
    if (name.empty())
      throw InputError(where + "passage.path names no file",
                       "it is the name of a CSV file with one line a place", "Give path = \"FILE.csv\".");
    path.emplace(sweep.text.folder / name, renamed_columns(passage, where));
    sweep.tables.push_back({"passage.path", name, path->file()});
  } else if (passage.contains("columns")) {
    throw InputError(where + "passage.columns is given without a path", "it says what columns of a path are",
                     "Give passage.path, or leave it out.");
  }
  std::vector<SchemaValue> places = given_places(passage, path, where);
  if (places.empty() && !path)
    throw InputError(where + "the passage has neither places nor a path", "there is nothing to solve",
                     "Give from, to and step in mm along the track.");
  if (places.empty())
    places = path->own_places();
  std::vector<SweepFile::Axis> axes{{along, places, line, true}};
  if (path)
    path->add_axes(places, line, axes);
  return axes;
}

} // namespace bem_contact
