#include "bem_contact/base/schema_text.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

namespace {

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

struct Print {
  std::string operator()(const double* v) const { return number_text(*v); }
  std::string operator()(const int* v) const { return fmt::format("{}", *v); }
  std::string operator()(const bool* v) const { return *v ? "true" : "false"; }
  std::string operator()(const std::string* v) const { return toml_text(*v); }
  std::string operator()(const Point2* v) const {
    return fmt::format("[{}, {}]", number_text(v->y), number_text(v->z));
  }
  std::string operator()(const std::vector<double>* list) const {
    std::vector<std::string> numbers;
    for (const double v : *list)
      numbers.push_back(number_text(v));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
  }
  template <class T> std::string operator()(const std::optional<T>* v) const {
    const T value = v->value_or(T{});
    return (*this)(&value);
  }
  std::string operator()(const NamedChoice& choice) const { return toml_text(choice.text()); }
  std::string operator()(const TableList& list) const { return list.example; }
};

struct TypeName {
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const int*) const { return "whole number"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const Point2*) const { return "two numbers"; }
  std::string operator()(const std::vector<double>*) const { return "list of numbers"; }
  template <class T> std::string operator()(const std::optional<T>*) const {
    return (*this)(static_cast<const T*>(nullptr));
  }
  std::string operator()(const NamedChoice&) const { return "text"; }
  std::string operator()(const TableList&) const { return "list of tables"; }
};

struct Type {
  KeyType operator()(const double*) const { return KeyType::number; }
  KeyType operator()(const int*) const { return KeyType::whole_number; }
  KeyType operator()(const bool*) const { return KeyType::flag; }
  KeyType operator()(const std::string*) const { return KeyType::text; }
  KeyType operator()(const Point2*) const { return KeyType::point; }
  KeyType operator()(const std::vector<double>*) const { return KeyType::numbers; }
  template <class T> KeyType operator()(const std::optional<T>*) const {
    return (*this)(static_cast<const T*>(nullptr));
  }
  KeyType operator()(const NamedChoice& choice) const {
    return choice.several ? KeyType::choices : KeyType::choice;
  }
  KeyType operator()(const TableList&) const { return KeyType::tables; }
};

struct Value {
  using Result = std::optional<SchemaValue>;
  Result operator()(const double* v) const { return *v; }
  Result operator()(const int* v) const { return std::int64_t{*v}; }
  Result operator()(const bool* v) const { return *v; }
  Result operator()(const std::string* v) const { return *v; }
  Result operator()(const Point2* v) const { return std::vector<double>{v->y, v->z}; }
  Result operator()(const std::vector<double>* v) const { return *v; }
  template <class T> Result operator()(const std::optional<T>* v) const {
    return *v ? (*this)(&**v) : std::nullopt;
  }
  Result operator()(const NamedChoice& choice) const { return choice.text(); }
  Result operator()(const TableList&) const { return std::nullopt; }
};

} // namespace

KeyType key_type(const SchemaTarget& target) {
  return std::visit(Type{}, target);
}

std::optional<SchemaValue> plain_value(const SchemaTarget& target) {
  return std::visit(Value{}, target);
}

std::string last_part(std::string_view path) {
  return std::string(path.substr(path.rfind('.') + 1));
}

std::string table_of(std::string_view path) {
  const auto dot = path.rfind('.');
  return dot == std::string_view::npos ? "" : std::string(path.substr(0, dot));
}

std::string toml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04X}", static_cast<int>(c));
    else
      out += c;
  }
  return out + "\"";
}

std::string value_text(const SchemaTarget& target) {
  return std::visit(Print{}, target);
}

std::string type_text(const SchemaTarget& target) {
  return std::visit(TypeName{}, target);
}

std::string range_text(const SchemaTarget& target, const KeyRule& rule) {
  std::vector<std::string> parts;
  if (std::isfinite(rule.above))
    parts.push_back(fmt::format("> {}", rule.above));
  if (std::isfinite(rule.at_least))
    parts.push_back(fmt::format(">= {}", rule.at_least));
  if (std::isfinite(rule.below))
    parts.push_back(fmt::format("< {}", rule.below));
  if (std::isfinite(rule.at_most))
    parts.push_back(fmt::format("<= {}", rule.at_most));
  if (const auto* choice = std::get_if<NamedChoice>(&target); choice && !choice->several)
    parts.push_back(fmt::format("{}", fmt::join(choice->names, " | ")));
  return fmt::format("{}", fmt::join(parts, " and "));
}

} // namespace bem_contact
