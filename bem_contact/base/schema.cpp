#include "bem_contact/base/schema.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

std::string with_unit(std::string text, const KeyRule& rule) {
  return rule.unit.empty() ? text : text + " " + rule.unit;
}

bool has_no_value(const SchemaTarget& target) {
  return std::visit(
      [](const auto& bound) {
        if constexpr (requires { bound->has_value(); })
          return !bound->has_value();
        else
          return false;
      },
      target);
}

} // namespace

void Schema::add_key(std::string path, SchemaTarget target, std::string doc, KeyRule rule) {
  std::string text = std::holds_alternative<TableList>(target) ? "" : value_text(target);
  keys_.push_back({std::move(path), std::move(doc), target, std::move(rule), std::move(text)});
}

void Schema::add(std::string path, std::vector<std::string>& values, std::vector<std::string> names,
                 std::string none, std::string doc, KeyRule rule) {
  names.insert(names.begin(), none);
  const auto set = [&values, names](const std::vector<std::size_t>& at) {
    values.clear();
    for (const std::size_t i : at)
      if (i > 0)
        values.push_back(names[i]);
  };
  const auto text = [&values, none] {
    return values.empty() ? none : fmt::format("{}", fmt::join(values, ", "));
  };
  add_key(std::move(path), NamedChoice{std::move(names), text, set, true}, std::move(doc), std::move(rule));
}

const Schema::Key* Schema::find(std::string_view path) const {
  const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) {
    return k.path == path || (!k.rule.formerly.empty() && k.rule.formerly == path);
  });
  return key == keys_.end() ? nullptr : &*key;
}

std::vector<std::string> Schema::former_names() const {
  std::vector<std::string> out;
  for (const std::string& path : formerly_)
    out.push_back(fmt::format("{} is now called {}", find(path)->rule.formerly, path));
  return out;
}

SchemaValue Schema::number_for(const std::string& path, double number) const {
  const Key* key = find(path);
  if (!key)
    refuse_unknown(path, false);
  const SchemaTarget& target = key->target;
  constexpr double exact = 9007199254740992.0; // 2^53: whole numbers beyond have no neighbours in a double
  if ((std::holds_alternative<int*>(target) || std::holds_alternative<std::optional<int>*>(target)) &&
      std::abs(number) < exact && number == std::floor(number))
    return static_cast<std::int64_t>(number);
  if (std::holds_alternative<bool*>(target) && (number == 0 || number == 1))
    return number == 1;
  return number;
}

bool Schema::changed(std::string_view path) const {
  const Key* key = find(path);
  return key && has(path) &&
         (std::holds_alternative<TableList>(key->target) || value_text(key->target) != key->default_text);
}

std::vector<std::string> Schema::keys_of(std::string_view table) const {
  std::vector<std::string> out;
  for (const Key& key : keys_)
    if (table_of(key.path) == table)
      out.push_back(last_part(key.path));
  return out;
}

std::string Schema::unit(std::string_view path) const {
  const Key* key = find(path);
  return key ? key->rule.unit : "";
}

bool Schema::belongs(const Key& key) const {
  const Key* kind = kind_path_.empty() ? nullptr : find(kind_path_);
  if (!kind || key.rule.kinds.empty())
    return true;
  return std::count(key.rule.kinds.begin(), key.rule.kinds.end(),
                    std::get<NamedChoice>(kind->target).text()) > 0;
}

std::string Schema::where(std::string_view path) const {
  // A missing key is reported at its table, if that is there.
  for (std::string at(path); !at.empty(); at = table_of(at))
    if (const auto line = lines_.find(at); line != lines_.end()) {
      const auto other = other_sources_.find(at);
      const std::string& source = other == other_sources_.end() ? source_ : other->second;
      return line->second > 0 ? fmt::format("{}:{}: ", source, line->second) : source + ": ";
    }
  return fmt::format("{}: ", source_);
}

void Schema::refuse(std::string_view path, std::string_view why, std::string_view what_to_do) const {
  const Key* key = find(path);
  const bool shown = key && has(path) && !std::holds_alternative<TableList>(key->target); // it has no value
  const std::string problem =
      shown ? fmt::format("{} = {}", path, value_text(key->target)) : std::string(path);
  throw InputError(where(path) + problem, why, what_to_do);
}

void Schema::refuse_unknown(const std::string& path, bool is_table) const {
  std::set<std::string> names = is_table ? skipped_ : std::set<std::string>();
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
  const std::string inner = last_part(path);
  if (const bool dotted =
          std::ranges::any_of(keys_, [&](const Key& key) { return key.path.starts_with(inner + "."); });
      is_table && inner != path && dotted)
    throw InputError(
        fmt::format("{}unknown table '{}'", where(path), path),
        fmt::format("keys below [{}] belong to it, those with dots too", table_of(path)),
        fmt::format("Write the keys {0}.* above the first line with [...], or below [{0}].", inner));
  throw InputError(fmt::format("{}unknown {} '{}'", where(path), is_table ? "table" : "key", path),
                   fmt::format("a {} has no such {}", title_, is_table ? "table" : "key"),
                   like.empty() ? "See --print-default (of bem_contact for scenes, of mesh_body for bodies)."
                                : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
}

void Schema::check(const Key& key) const {
  const KeyRule& rule = key.rule;
  const auto check_number = [&](double value) {
    if (!std::isfinite(value))
      refuse(key.path, "the value must be finite", "Give a number.");
    if (!(value >= rule.at_least && value > rule.above && value <= rule.at_most && value < rule.below))
      refuse(
          key.path, "out of range",
          fmt::format("Give a value {}. It is: {}.", with_unit(range_text(key.target, rule), rule), key.doc));
  };
  const auto check_value = [&](const auto& self, const auto& value) -> void {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, int>)
      check_number(value);
    else if constexpr (std::is_same_v<T, Point2>)
      check_number(value.y), check_number(value.z);
    else if constexpr (std::is_same_v<T, std::vector<double>>)
      std::ranges::for_each(value, check_number);
    else if constexpr (requires { value.has_value(); })
      value ? self(self, *value) : void();
  };
  std::visit(
      [&](const auto& target) {
        if constexpr (std::is_pointer_v<std::decay_t<decltype(target)>>)
          check_value(check_value, *target);
      },
      key.target);
}

void Schema::require_needed() const {
  for (const Key& key : keys_)
    if (key.rule.needed && !has(key.path))
      throw InputError(
          where(key.path) + key.path + " is missing", key.doc,
          fmt::format("Give it, for instance {} = {}.", last_part(key.path), value_text(key.target)));
}

void Schema::require_kind(const Key& key) const {
  if (!has(key.path) || belongs(key))
    return;
  const std::string kind = std::get<NamedChoice>(find(kind_path_)->target).text();
  refuse(key.path,
         fmt::format("the key has no meaning where {} is \"{}\", only where it is {}", kind_path_, kind,
                     fmt::join(key.rule.kinds, " or ")),
         "Remove it.");
}

std::vector<KeyDescription> Schema::describe() const {
  std::vector<KeyDescription> out;
  for (const Key& key : keys_) {
    KeyDescription one{key.path, key.doc, key_type(key.target), key.rule};
    if (const auto* choice = std::get_if<NamedChoice>(&key.target))
      one.choices = choice->names;
    if (const auto* list = std::get_if<TableList>(&key.target)) {
      one.columns = list->next().describe();
      list->clear();
    }
    if (!key.rule.example && !key.rule.commented_out && !has_no_value(key.target))
      one.value = plain_value(key.target);
    out.push_back(std::move(one));
  }
  return out;
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
    std::vector<std::string> facts{type_text(key.target)};
    if (!key.rule.unit.empty())
      facts.push_back(key.rule.unit);
    if (const std::string range = range_text(key.target, key.rule); !range.empty())
      facts.push_back(range);
    if (!std::holds_alternative<TableList>(key.target))
      facts.push_back((key.rule.example ? "no default, for instance " : "default ") + key.default_text);
    if (!key.rule.kinds.empty())
      facts.push_back(fmt::format("only where {} is {}", kind_path_, fmt::join(key.rule.kinds, " or ")));
    const bool off = !belongs(key) || key.rule.commented_out ||
                     std::holds_alternative<TableList>(key.target) ||
                     (has_no_value(key.target) && !key.rule.zero_is_none);
    out += fmt::format("# {} ({})\n{}{} = {}\n", key.doc, fmt::join(facts, "; "), off ? "# " : "",
                       last_part(key.path), value_text(key.target));
  }
  for (const Key& key : keys_)
    if (const auto* list = std::get_if<TableList>(&key.target); list && list->rows)
      for (const Schema& row : list->rows()) {
        out += fmt::format("\n[[{}]]\n", key.path);
        for (const Key& column : row.keys_)
          out += fmt::format("{} = {}\n", last_part(column.path), value_text(column.target));
      }
  return out;
}

} // namespace bem_contact
