#include "bem_contact/record/json.hpp"

#include "bem_contact/record/found.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <nlohmann/json.hpp>

namespace bem_contact::record {

namespace {

using json = nlohmann::ordered_json;

json number_json(double value, bool whole) {
  if (!std::isfinite(value))
    return nullptr;
  return whole ? json(static_cast<std::int64_t>(value)) : json(value);
}

/// [x][y] as lists of lists, from the dimension `at` on.
json nested(const Field& field, std::size_t at, std::span<const double> values) {
  json out = json::array();
  const std::size_t length = field.shape[at], part = length == 0 ? 0 : values.size() / length;
  for (std::size_t i = 0; i < length; ++i)
    if (at + 1 == field.shape.size())
      out.push_back(number_json(values[i], false));
    else
      out.push_back(nested(field, at + 1, values.subspan(i * part, part)));
  return out;
}

json table_json(const Table& table) {
  const auto cell = [](const Column& column, std::size_t row) {
    return number_json(column.values[row], column.whole);
  };
  if (table.layout == Layout::columns) {
    json out = json::object();
    for (const Column& column : table.columns) {
      json& values = out[column.name] = json::array();
      for (std::size_t row = 0; row < table.size(); ++row)
        values.push_back(cell(column, row));
    }
    return out;
  }
  json out = json::array();
  for (std::size_t row = 0; row < table.size(); ++row) {
    json& one = out.emplace_back(json::object());
    for (const Column& column : table.columns)
      one[column.name] = cell(column, row);
  }
  return out;
}

json group_json(const Record& record);

struct ToJson {
  json operator()(std::monostate) const { return nullptr; }
  json operator()(bool flag) const { return flag; }
  json operator()(const Number& number) const { return number_json(number.value, number.whole); }
  json operator()(const Text& text) const { return text.text; }
  json operator()(const Texts& texts) const { return texts.lines; }
  json operator()(const Field& values) const { return nested(values, 0, values.values); }
  json operator()(const Table& table) const { return table_json(table); }
  json operator()(const Record& record) const { return group_json(record); }
};

json group_json(const Record& record) {
  json out = json::object();
  for (const Entry& entry : record.entries()) {
    out[entry.name] = std::visit(ToJson{}, entry.content);
    if (const auto* number = std::get_if<Number>(&entry.content); number && number->error)
      out[error_name(entry.name)] = number_json(*number->error, false);
  }
  return out;
}

void add_unit(json& units, const std::string& group, const std::string& name, const std::string& unit) {
  if (!units.contains(name))
    units[name] = unit;
  else if (units[name] != unit)
    units[group + name] = unit;
}

void add_units(json& units, const std::string& group, const Record& record) {
  for (const auto& [name, content] : record.entries())
    if (const auto* number = std::get_if<Number>(&content))
      add_unit(units, group, name, number->unit);
    else if (const auto* values = std::get_if<Field>(&content))
      add_unit(units, group, name, values->unit);
    else if (const auto* inner = std::get_if<Record>(&content))
      add_units(units, group + name + "/", *inner);
    else if (const auto* table = std::get_if<Table>(&content))
      for (const Column& column : table->columns)
        add_unit(units, group + name + "/", column.name, column.unit);
}

/// A text of a file that is no UTF-8 must not end the program.
constexpr auto replacing = json::error_handler_t::replace;

json list_of(std::span<const double> values) {
  json out = json::array();
  for (const double value : values)
    out.push_back(number_json(value, false));
  return out;
}

/// `errors`: as many as values, or none.
json described(const std::string& unit, const std::string& meaning, const std::vector<std::size_t>& shape,
               std::span<const double> values, std::span<const double> errors = {}) {
  json out{{"unit", unit}, {"description", meaning}, {"shape", shape}, {"values", list_of(values)}};
  if (!errors.empty())
    out["errors"] = list_of(errors);
  return out;
}

/// Errors stand beside their values, under names of their own: those of each name.
using Errors = std::map<std::string_view, std::span<const double>>;

/// `one`: a field or a column.
template <class One> void add_errors(Errors& errors, const One& one) {
  if (one.role == Role::error)
    errors[one.of] = one.values;
}

void add_role(json& numbers, Role role, const std::string& of) {
  if (role != Role::other)
    numbers["role"] = name_of(role);
  if (!of.empty())
    numbers["of"] = of;
}

/// Adds what the group `path` holds to `out`.
class Describing {
public:
  Describing(json& out, std::string path, const std::function<bool(std::string_view)>& left_out)
      : out_(&out), path_(std::move(path)), left_out_(&left_out) {}

  void add(const Record& record) {
    for (const Entry& entry : record.entries())
      if (const auto* field = std::get_if<Field>(&entry.content))
        add_errors(errors_, *field);
    for (const Entry& entry : record.entries())
      if (const auto* field = std::get_if<Field>(&entry.content);
          !(*left_out_)(path_ + entry.name) &&
          !(field && field->role == Role::error && find(record, field->of))) {
        name_ = entry.name;
        std::visit(*this, entry.content);
      }
  }

  void operator()(std::monostate) {}
  void operator()(bool flag) { (*out_)["attributes"][name_] = flag ? 1 : 0; }
  void operator()(const Number& number) {
    const auto error = number.error ? std::span(&*number.error, 1) : std::span<const double>();
    (*out_)[name_] = described(number.unit, number.meaning, {}, std::span(&number.value, 1), error);
  }
  void operator()(const Text& text) {
    if (text.meaning.empty())
      (*out_)["attributes"][name_] = text.text;
    else
      (*out_)[name_] = {{"text", text.text}, {"description", text.meaning}};
  }
  void operator()(const Texts& texts) {
    (*out_)[name_] = {{"text", fmt::format("{}", fmt::join(texts.lines, "\n"))},
                      {"description", texts.meaning}};
  }
  void operator()(const Field& values) {
    if (values.shape.size() > 3)
      return;
    json& numbers = (*out_)[name_] = described(values.unit, values.meaning, values.shape, values.values,
                                               of_name(errors_, name_, values.values.size()));
    add_role(numbers, values.role, values.of);
    if (!values.choices.empty())
      numbers["choices"] = values.choices;
  }
  void operator()(const Table& table) {
    json& columns = (*out_)[name_] = json::object();
    Errors errors;
    for (const Column& column : table.columns)
      add_errors(errors, column);
    for (const Column& column : table.columns)
      if (!(*left_out_)(path_ + name_ + "/" + column.name) &&
          !(column.role == Role::error && table.column(column.of))) {
        json& numbers = columns[column.name] =
            described(column.unit, column.meaning, {table.size()}, column.values,
                      of_name(errors, column.name, column.values.size()));
        add_role(numbers, column.role, column.of);
      }
  }
  void operator()(const Record& record) {
    json& group = (*out_)[name_] = json::object();
    Describing(group, path_ + name_ + "/", *left_out_).add(record);
  }

private:
  static std::span<const double> of_name(const Errors& errors, const std::string& name, std::size_t count) {
    const auto own = errors.find(name);
    return own == errors.end() || own->second.size() != count ? std::span<const double>() : own->second;
  }

  json* out_;
  std::string path_, name_;
  Errors errors_; ///< of the fields of this group
  const std::function<bool(std::string_view)>* left_out_;
};

} // namespace

std::string to_json(const Record& answer) {
  const Record record = with_found(answer);
  json out = group_json(record), units = json::object();
  add_units(units, "", record);
  if (!units.empty())
    out["units"] = std::move(units);
  return out.dump(2, ' ', false, replacing);
}

std::string to_described_json(const Record& record, const std::function<bool(std::string_view)>& left_out) {
  json out = json::object();
  Describing(out, "", left_out).add(record);
  return out.dump(-1, ' ', false, replacing);
}

} // namespace bem_contact::record
