#include "bem_contact/record/record.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>

namespace bem_contact::record {

namespace {

/// What stands before the first "/", and what behind it.
std::pair<std::string_view, std::string_view> first_of(std::string_view path) {
  const std::size_t slash = path.find('/');
  return slash == path.npos ? std::pair(path, std::string_view())
                            : std::pair(path.substr(0, slash), path.substr(slash + 1));
}

/// `inner`: something with parts. Old files have a text and a group of one name.
const Content* entry(const Record& record, std::string_view name, bool inner) {
  const auto has_parts = [](const Content& content) {
    return std::holds_alternative<Record>(content) || std::holds_alternative<Table>(content) ||
           std::holds_alternative<Field>(content);
  };
  const auto found = std::ranges::find_if(record.entries(), [&](const Entry& one) {
    return one.name == name && (!inner || has_parts(one.content));
  });
  return found == record.entries().end() ? nullptr : &found->content;
}

std::optional<std::size_t> index_of(std::string_view text) {
  std::size_t index = 0;
  const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), index);
  return wrong == std::errc() && end == text.data() + text.size() && !text.empty() ? std::optional(index)
                                                                                   : std::nullopt;
}

/// The entry as deep as it goes, and what is left of the path: the way into a table or a field.
std::pair<const Content*, std::string_view> deepest(const Record& record, std::string_view path) {
  const Record* at = &record;
  while (true) {
    const auto [name, rest] = first_of(path);
    const Content* content = entry(*at, name, !rest.empty());
    at = content ? std::get_if<Record>(content) : nullptr;
    if (!at || rest.empty())
      return {content, rest};
    path = rest;
  }
}

std::optional<double> at(std::span<const double> values, std::string_view index) {
  const auto i = index_of(index);
  return i && *i < values.size() ? std::optional(values[*i]) : std::nullopt;
}

/// "0/Fn"
std::optional<double> in_table(const Table& table, std::string_view path) {
  const auto [row, name] = first_of(path);
  const Column* column = table.column(name);
  return column ? at(column->values, row) : std::nullopt;
}

constexpr std::string_view error_ending = "_error";

constexpr std::size_t most_like = 3; // paths that a message names

std::string_view last_name(std::string_view path) {
  return path.substr(path.rfind('/') + 1); // npos + 1 is 0
}

void add_paths(std::vector<std::string>& out, const std::string& path, const Content& content) {
  out.push_back(path);
  if (const auto* number = std::get_if<Number>(&content); number && number->error)
    out.push_back(error_name(path));
  else if (const auto* table = std::get_if<Table>(&content); table && table->size() > 0)
    for (const Column& column : table->columns)
      out.push_back(path + "/0/" + column.name);
  else if (const auto* group = std::get_if<Record>(&content))
    for (const Entry& one : group->entries())
      add_paths(out, path + "/" + one.name, one.content);
}

} // namespace

Field field(std::vector<double> values, std::string unit, std::string meaning,
            std::vector<std::size_t> shape) {
  const auto owner = std::make_shared<const std::vector<double>>(std::move(values));
  if (shape.empty())
    shape = {owner->size()};
  return {std::move(unit), std::move(meaning), std::move(shape), *owner, owner};
}

const Column* Table::column(std::string_view name) const {
  const auto found = std::ranges::find(columns, name, &Column::name);
  return found == columns.end() ? nullptr : &*found;
}

Record& Record::append(Record other) {
  std::ranges::move(other.entries_, std::back_inserter(entries_));
  return *this;
}

std::string error_name(std::string_view name) {
  return std::string(name).append(error_ending);
}

const Content* find(const Record& record, std::string_view path) {
  const auto [content, rest] = deepest(record, path);
  return rest.empty() ? content : nullptr;
}

std::optional<double> number_at(const Record& record, std::string_view path) {
  const auto [content, rest] = deepest(record, path);
  if (!content && path.ends_with(error_ending)) {
    const Content* of = find(record, path.substr(0, path.size() - error_ending.size()));
    const auto* number = of ? std::get_if<Number>(of) : nullptr;
    return number ? number->error : std::nullopt;
  }
  if (!content)
    return std::nullopt;
  if (const auto* table = std::get_if<Table>(content))
    return in_table(*table, rest);
  if (const auto* values = std::get_if<Field>(content))
    return values->shape.size() == 1 ? at(values->values, rest) : std::nullopt;
  if (!rest.empty())
    return std::nullopt;
  if (const auto* number = std::get_if<Number>(content))
    return number->value;
  if (const auto* flag = std::get_if<bool>(content))
    return *flag ? 1 : 0;
  return std::nullopt;
}

std::optional<std::string_view> text_at(const Record& record, std::string_view path) {
  const Content* content = find(record, path);
  const auto* text = content ? std::get_if<Text>(content) : nullptr;
  return text ? std::optional<std::string_view>(text->text) : std::nullopt;
}

std::optional<bool> flag_at(const Record& record, std::string_view path) {
  const Content* content = find(record, path);
  const auto* flag = content ? std::get_if<bool>(content) : nullptr;
  return flag ? std::optional(*flag) : std::nullopt;
}

std::span<const double> values_at(const Record& record, std::string_view path) {
  const auto [content, rest] = deepest(record, path);
  if (!content)
    return {};
  if (const auto* values = std::get_if<Field>(content); values && rest.empty())
    return values->values;
  const auto* table = std::get_if<Table>(content);
  const Column* column = table ? table->column(rest) : nullptr;
  return column ? std::span<const double>(column->values) : std::span<const double>();
}

bool has(const Record& record, std::string_view path) {
  return find(record, path) || number_at(record, path) || !values_at(record, path).empty();
}

std::vector<std::string> paths_of(const Record& record) {
  std::vector<std::string> out;
  for (const Entry& one : record.entries())
    add_paths(out, one.name, one.content);
  return out;
}

InputError unknown_path(const Record& record, std::string_view path, std::string_view what) {
  const std::vector<std::string> known = paths_of(record);
  std::vector<std::string> like;
  for (const std::string& one : known)
    if (last_name(one) == path && like.size() < most_like)
      like.push_back(one);
  if (like.empty())
    like = nearest_names(path, known, most_like);
  std::string advice;
  for (const std::string& one : like)
    advice += (&one == &like.front() ? "Did you mean " : &one == &like.back() ? " or " : ", ") + one;
  advice += like.empty() ? "See bem_contact solve --json for all of them." : "?";
  return {"There is no path '" + std::string(path) + "'", "the " + std::string(what) + " has nothing there",
          advice};
}

} // namespace bem_contact::record
