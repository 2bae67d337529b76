#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/schema_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <limits>

namespace bem_contact {

namespace {

std::string type_of(const toml::node& node) {
  if (node.is_integer())
    return "a whole number";
  if (node.is_floating_point())
    return "a number";
  if (node.is_boolean())
    return "true or false";
  if (node.is_string())
    return "text";
  if (node.is_table())
    return "a table";
  return node.is_array() ? "a list" : "a date or time";
}

} // namespace

struct SchemaReader {
  Schema& schema;

  void table(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : table) {
      const std::string path =
          prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
      // A table made by a dotted key has no line of its own; its key has.
      const auto begin = node.source().begin.line ? node.source().begin : name.source().begin;
      schema.lines_[path] = static_cast<int>(begin.line);
      if (node.is_table() && path == schema.skipped_)
        continue;
      if (const Schema::Key* key = schema.find(path)) {
        assign(*key, node);
        continue;
      }
      const bool known_table =
          std::any_of(schema.keys_.begin(), schema.keys_.end(),
                      [&](const Schema::Key& k) { return k.path.starts_with(path + "."); });
      if (known_table && !node.is_table())
        throw InputError(schema.where(path) + path + " is " + type_of(node), "it is the name of a table",
                         "Write [" + path + "] and its keys below.");
      if (!known_table)
        schema.refuse_unknown(path, node.is_table());
      this->table(*node.as_table(), path);
    }
  }

  void assign(const Schema::Key& key, const toml::node& node) {
    const auto wrong_type = [&]() {
      throw InputError(
          schema.where(key.path) + key.path + " is " + type_of(node),
          fmt::format("it must be of type: {}", type_text(key.target)),
          fmt::format("Correct it, for instance {} = {}.", last_part(key.path), value_text(key.target)));
    };
    if (auto* const* number = std::get_if<double*>(&key.target)) {
      if (!node.is_number())
        wrong_type();
      **number = *node.value<double>();
    } else if (auto* const* whole = std::get_if<int*>(&key.target)) {
      if (!node.is_integer())
        wrong_type();
      const std::int64_t value = *node.value<std::int64_t>();
      if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
        throw InputError(fmt::format("{}{} = {}", schema.where(key.path), key.path, value), "out of range",
                         "Give a smaller value.");
      **whole = static_cast<int>(value);
    } else if (auto* const* flag = std::get_if<bool*>(&key.target)) {
      if (!node.is_boolean())
        wrong_type();
      **flag = *node.value<bool>();
    } else if (auto* const* point = std::get_if<Point2*>(&key.target)) {
      const toml::array* pair = node.as_array();
      if (!pair || pair->size() != 2 || !(*pair)[0].is_number() || !(*pair)[1].is_number())
        wrong_type();
      **point = {*(*pair)[0].value<double>(), *(*pair)[1].value<double>()};
    } else if (auto* const* numbers = std::get_if<std::vector<double>*>(&key.target)) {
      if (!node.is_array())
        wrong_type();
      (*numbers)->clear();
      for (const toml::node& element : *node.as_array()) {
        if (!element.is_number())
          wrong_type();
        (*numbers)->push_back(*element.value<double>());
      }
    } else if (const auto* list = std::get_if<TableList>(&key.target)) {
      if (!node.is_array_of_tables() && !(node.is_array() && node.as_array()->empty()))
        wrong_type();
      list->clear();
      for (const toml::node& element : *node.as_array()) {
        Schema row = list->next();
        row.source_ = schema.source_;
        row.lines_[key.path] = static_cast<int>(element.source().begin.line);
        SchemaReader{row}.table(*element.as_table(), key.path);
        row.require_needed();
      }
    } else {
      if (!node.is_string())
        wrong_type();
      std::string text = *node.value<std::string>();
      if (text.find('\0') != std::string::npos)
        schema.refuse(key.path, "its text holds the character NUL", "Take it out.");
      *std::get<std::string*>(key.target) = std::move(text);
    }
    schema.check(key);
    if (key.rule.given)
      *key.rule.given = true;
  }
};

void Schema::read(std::string_view toml, std::string_view source_name) {
  source_ = source_name;
  lines_.clear();
  try {
    SchemaReader{*this}.table(toml::parse(toml, source_name), "");
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", source_name, error.source().begin.line, error.description()),
                     "the file is not valid TOML", "Correct the line.");
  }
  require_needed();
  for (const Key& key : keys_)
    require_kind(key);
}

void Schema::set(const std::string& path, const SchemaValue& value, int line) {
  lines_[path] = line;
  const Key* key = find(path);
  if (!key)
    refuse_unknown(path, false);
  std::visit([&](const auto& v) { SchemaReader{*this}.assign(*key, toml::value(v)); }, value);
  require_kind(*key);
}

} // namespace bem_contact
