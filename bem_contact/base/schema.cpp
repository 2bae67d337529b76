#include "bem_contact/base/schema.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace bem_contact {

namespace {

std::string last_part(std::string_view path) {
  return std::string(path.substr(path.rfind('.') + 1));
}

std::string table_of(std::string_view path) {
  const auto dot = path.rfind('.');
  return dot == std::string_view::npos ? "" : std::string(path.substr(0, dot));
}

std::string number_text(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

/// A TOML basic string.
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
  std::string operator()(const TableList& list) const { return list.example; }
};

struct TypeName {
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const int*) const { return "whole number"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const Point2*) const { return "two numbers"; }
  std::string operator()(const std::vector<double>*) const { return "list of numbers"; }
  std::string operator()(const TableList&) const { return "list of tables"; }
};

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

std::string range_text(const KeyRule& rule) {
  std::vector<std::string> parts;
  if (std::isfinite(rule.above))
    parts.push_back(fmt::format("> {}", rule.above));
  if (std::isfinite(rule.at_least))
    parts.push_back(fmt::format(">= {}", rule.at_least));
  if (std::isfinite(rule.below))
    parts.push_back(fmt::format("< {}", rule.below));
  if (std::isfinite(rule.at_most))
    parts.push_back(fmt::format("<= {}", rule.at_most));
  if (!rule.choices.empty())
    parts.push_back(fmt::format("{}", fmt::join(rule.choices, " | ")));
  return fmt::format("{}", fmt::join(parts, " and "));
}

std::string with_unit(std::string text, const KeyRule& rule) {
  return rule.unit.empty() ? text : text + " " + rule.unit;
}

} // namespace

void Schema::add_key(std::string path, Target target, KeyRule rule) {
  if (rule.given)
    *rule.given = false;
  keys_.push_back({std::move(path), target, std::move(rule)});
}

const Schema::Key* Schema::find(std::string_view path) const {
  const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.path == path; });
  return key == keys_.end() ? nullptr : &*key;
}

bool Schema::belongs(const Key& key) const {
  const Key* kind = kind_path_.empty() ? nullptr : find(kind_path_);
  if (!kind || key.rule.kinds.empty())
    return true;
  return std::count(key.rule.kinds.begin(), key.rule.kinds.end(), *std::get<std::string*>(kind->target)) > 0;
}

std::string Schema::where(std::string_view path) const {
  // A missing key is reported at its table, if that is there.
  for (std::string at(path); !at.empty(); at = table_of(at))
    if (const auto line = lines_.find(at); line != lines_.end())
      return line->second > 0 ? fmt::format("{}:{}: ", source_, line->second) : source_ + ": ";
  return fmt::format("{}: ", source_);
}

void Schema::refuse(std::string_view path, std::string_view why, std::string_view what_to_do) const {
  const Key* key = find(path);
  const std::string problem =
      key && has(path) ? fmt::format("{} = {}", path, std::visit(Print{}, key->target)) : std::string(path);
  throw InputError(where(path) + problem, why, what_to_do);
}

void Schema::refuse_unknown(const std::string& path, bool is_table) const {
  std::set<std::string> names;
  for (const Key& key : keys_) {
    if (!is_table)
      names.insert(key.path);
    for (std::string table = table_of(key.path); is_table && !table.empty(); table = table_of(table))
      names.insert(table);
  }
  const std::vector<std::string> candidates(names.begin(), names.end());
  std::vector<std::string> like = nearest_names(path, candidates);
  if (!is_table) { // the same key may stand in another table, or the table's name makes all else look alike
    std::vector<std::string> own, parts;
    for (const std::string& name : candidates)
      (table_of(name) == table_of(path) ? own : parts).push_back(last_part(name));
    std::vector<std::string> better;
    for (const std::string& name : nearest_names(last_part(path), own))
      better.push_back(table_of(path).empty() ? name : table_of(path) + "." + name);
    for (const std::string& part : nearest_names(last_part(path), parts, 1))
      for (const std::string& name : candidates)
        if (last_part(name) == part && table_of(name) != table_of(path) && better.size() < 3)
          better.push_back(name);
    if (!better.empty())
      like = better;
  }
  throw InputError(fmt::format("{}unknown {} '{}'", where(path), is_table ? "table" : "key", path),
                   fmt::format("a {} has no such {}", title_, is_table ? "table" : "key"),
                   like.empty() ? "See --print-default for all of them."
                                : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
}

void Schema::check(const Key& key) const {
  const KeyRule& rule = key.rule;
  const auto check_number = [&](double value) {
    if (!std::isfinite(value))
      refuse(key.path, "the value must be finite", "Give a number.");
    if (!(value >= rule.at_least && value > rule.above && value <= rule.at_most && value < rule.below))
      refuse(key.path, "out of range", fmt::format("Give a value {}.", with_unit(range_text(rule), rule)));
  };
  if (const auto* number = std::get_if<double*>(&key.target))
    check_number(**number);
  if (const auto* whole = std::get_if<int*>(&key.target))
    check_number(**whole);
  if (auto* const* point = std::get_if<Point2*>(&key.target)) {
    check_number((*point)->y);
    check_number((*point)->z);
  }
  if (auto* const* list = std::get_if<std::vector<double>*>(&key.target))
    std::for_each((*list)->begin(), (*list)->end(), check_number);
  if (const auto* text = std::get_if<std::string*>(&key.target); text && !rule.choices.empty()) {
    if (std::count(rule.choices.begin(), rule.choices.end(), **text))
      return;
    const auto like = nearest_names(**text, rule.choices, 1);
    refuse(key.path, fmt::format("known are {}", fmt::join(rule.choices, ", ")),
           like.empty() ? "Use one of these." : fmt::format("Did you mean \"{}\"?", like.front()));
  }
}

struct SchemaReader {
  Schema& schema;

  void table(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : table) {
      const std::string path =
          prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
      if (node.is_table() && path == schema.skipped_)
        continue;
      // A table made by a dotted key has no line of its own; its key has.
      const auto begin = node.source().begin.line ? node.source().begin : name.source().begin;
      schema.lines_[path] = static_cast<int>(begin.line);
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
      throw InputError(schema.where(key.path) + key.path + " is " + type_of(node),
                       fmt::format("it must be of type: {}", std::visit(TypeName{}, key.target)),
                       fmt::format("Correct it, for instance {} = {}.", last_part(key.path),
                                   std::visit(Print{}, key.target)));
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

void Schema::require_needed() const {
  for (const Key& key : keys_)
    if (key.rule.needed && !has(key.path))
      throw InputError(where(key.path) + key.path + " is missing", key.rule.doc,
                       fmt::format("Give it, for instance {} = {}.", last_part(key.path),
                                   std::visit(Print{}, key.target)));
}

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

void Schema::require_kind(const Key& key) const {
  if (!has(key.path) || belongs(key))
    return;
  const std::string kind = *std::get<std::string*>(find(kind_path_)->target);
  refuse(key.path,
         fmt::format("the key has no meaning where {} is \"{}\", only where it is {}", kind_path_, kind,
                     fmt::join(key.rule.kinds, " or ")),
         "Remove it.");
}

void Schema::set(const std::string& path, const SchemaValue& value, int line) {
  lines_[path] = line;
  const Key* key = find(path);
  if (!key)
    refuse_unknown(path, false);
  std::visit([&](const auto& v) { SchemaReader{*this}.assign(*key, toml::value(v)); }, value);
  require_kind(*key);
}

std::string Schema::print() const {
  std::string out = fmt::format("# The whole schema of a {}. A key left out has its default.\n\n", title_);
  std::string table;
  for (const Key& key : keys_) {
    if (table_of(key.path) != table) {
      out += table.empty() && out.back() == '\n' && out[out.size() - 2] == '\n' ? "" : "\n";
      table = table_of(key.path);
      out += "[" + table + "]\n";
    }
    std::vector<std::string> facts{std::visit(TypeName{}, key.target)};
    if (!key.rule.unit.empty())
      facts.push_back(key.rule.unit);
    if (const std::string range = range_text(key.rule); !range.empty())
      facts.push_back(range);
    if (!std::holds_alternative<TableList>(key.target))
      facts.push_back("default " + std::visit(Print{}, key.target));
    if (!key.rule.kinds.empty())
      facts.push_back(fmt::format("only where {} is {}", kind_path_, fmt::join(key.rule.kinds, " or ")));
    const bool off = !belongs(key) || key.rule.alternative || (key.rule.given && !*key.rule.given) ||
                     std::holds_alternative<TableList>(key.target);
    out += fmt::format("# {} ({})\n{}{} = {}\n", key.rule.doc, fmt::join(facts, "; "), off ? "# " : "",
                       last_part(key.path), std::visit(Print{}, key.target));
  }
  return out;
}

std::string read_text_file(const std::string& file, std::string_view what) {
  if (std::filesystem::is_directory(file))
    throw InputError(fmt::format("{} '{}' cannot be read", what, file), "it is a folder", "Name a file.");
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(fmt::format("{} '{}' cannot be read", what, file),
                     std::filesystem::exists(file) ? "no permission" : "there is no such file",
                     "Check the path; relative paths start in the folder of the file that names them.");
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

} // namespace bem_contact
