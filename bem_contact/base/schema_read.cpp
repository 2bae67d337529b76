#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"
#include "bem_contact/base/schema.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/base/toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>

namespace bem_contact {

namespace {

std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1 && text.find('\n') != text.npos; --number)
    text.remove_prefix(text.find('\n') + 1);
  return text.substr(0, text.find('\n'));
}

/// The value of "key = 1/40", if the line is like that.
std::optional<double> fraction_in(std::string_view line) {
  const std::size_t sign = line.find('=');
  return sign == line.npos ? std::nullopt : fraction_of(line.substr(sign + 1, line.find('#') - sign - 1));
}

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

/// What stands between commas, without the blanks around it; one text at least.
std::vector<std::string> split_at_commas(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in >> std::ws, part, ',');)
    parts.push_back(part.substr(0, part.find_last_not_of(" \t\r\n") + 1));
  return parts.empty() ? std::vector<std::string>{""} : parts;
}

} // namespace

class SchemaReader {
public:
  explicit SchemaReader(Schema& bound) : schema(bound) {}

  void table(const toml::table& table, const std::string& prefix) {
    for (const auto& [name, node] : table) {
      const std::string path =
          prefix.empty() ? std::string(name.str()) : prefix + "." + std::string(name.str());
      // A table made by a dotted key has no line of its own; its key has.
      const auto begin = node.source().begin.line ? node.source().begin : name.source().begin;
      if (node.is_table() && schema.skipped_.contains(path)) {
        schema.lines_[path] = static_cast<int>(begin.line);
        continue;
      }
      if (const Schema::Key* key = schema.find(path)) {
        schema.take_line(*key, path, static_cast<int>(begin.line));
        assign(*key, node);
        continue;
      }
      schema.lines_[path] = static_cast<int>(begin.line);
      const bool known_table =
          std::any_of(schema.keys_.begin(), schema.keys_.end(),
                      [&](const Schema::Key& k) { return k.path.starts_with(path + "."); });
      if (!known_table && schema.shared_.contains(prefix))
        continue;
      if (known_table && !node.is_table())
        throw InputError(schema.where(path) + path + " is " + type_of(node), "it is the name of a table",
                         "Write [" + path + "] and its keys below.");
      if (!known_table)
        schema.refuse_unknown(path, node.is_table());
      this->table(*node.as_table(), path);
    }
  }

  void assign(const Schema::Key& key, const toml::node& node) {
    std::visit(
        [&](const auto& target) {
          if constexpr (std::is_pointer_v<std::decay_t<decltype(target)>>)
            take(key, node, *target);
          else
            take(key, node, target);
        },
        key.target);
    schema.check(key);
  }

private:
  Schema& schema;

  /// The value as it is; where that is refused or empty, 1 stands for it.
  static std::string example_text(const Schema::Key& key) {
    const std::string text = value_text(key.target);
    if (text == "[]" && std::holds_alternative<std::vector<double>*>(key.target))
      return "[1.0]";
    return (text == "0.0" && key.rule.above >= 0) ? fmt::format("{:.1f}", key.rule.above + 1) : text;
  }

  void require_type(const Schema::Key& key, const toml::node& node, bool fits) const {
    if (!fits)
      throw InputError(
          schema.where(key.path) + key.path + " is " + type_of(node),
          fmt::format("it must be of type: {}{}", type_text(key.target),
                      node.is_string() && !key.rule.unit.empty() ? ", in " + key.rule.unit : ""),
          fmt::format("Correct it, for instance {} = {}.", last_part(key.path), example_text(key)));
  }

  void take(const Schema::Key& key, const toml::node& node, double& number) {
    require_type(key, node, node.is_number());
    number = *node.value<double>();
  }

  void take(const Schema::Key& key, const toml::node& node, int& whole) {
    require_type(key, node, node.is_integer());
    const std::int64_t value = *node.value<std::int64_t>();
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
      throw InputError(fmt::format("{}{} = {}", schema.where(key.path), key.path, value), "out of range",
                       "Give a smaller value.");
    whole = static_cast<int>(value);
  }

  void take(const Schema::Key& key, const toml::node& node, bool& flag) {
    require_type(key, node, node.is_boolean());
    flag = *node.value<bool>();
  }

  void take(const Schema::Key& key, const toml::node& node, std::string& text) {
    require_type(key, node, node.is_string());
    std::string value = *node.value<std::string>();
    if (value.find('\0') != std::string::npos)
      schema.refuse(key.path, "its text holds the character NUL", "Take it out.");
    text = std::move(value);
  }

  void take(const Schema::Key& key, const toml::node& node, Point2& point) {
    const toml::array* pair = node.as_array();
    require_type(key, node, pair && pair->size() == 2 && (*pair)[0].is_number() && (*pair)[1].is_number());
    point = {*(*pair)[0].value<double>(), *(*pair)[1].value<double>()};
  }

  template <class T> void take(const Schema::Key& key, const toml::node& node, std::optional<T>& optional) {
    T value{};
    take(key, node, value);
    optional = value;
    if constexpr (!std::is_same_v<T, Point2>)
      if (key.rule.zero_is_none && value == 0)
        optional.reset();
  }

  void take(const Schema::Key& key, const toml::node& node, std::vector<double>& numbers) {
    require_type(key, node, node.is_array());
    numbers.clear();
    for (const toml::node& element : *node.as_array()) {
      require_type(key, node, element.is_number());
      numbers.push_back(*element.value<double>());
    }
  }

  void take(const Schema::Key& key, const toml::node& node, const NamedChoice& choice) {
    std::string text;
    const toml::array* list = choice.several ? node.as_array() : nullptr;
    if (list && list->empty())
      return choice.set({});
    if (list)
      for (const toml::node& element : *list) {
        std::string name;
        take(key, element, name);
        text += (text.empty() ? "" : ", ") + name;
      }
    else
      take(key, node, text);
    std::vector<std::size_t> chosen;
    for (const std::string& name : choice.several ? split_at_commas(text) : std::vector{text}) {
      const auto found = std::ranges::find(choice.names, name);
      if (found == choice.names.end()) {
        const auto like = nearest_names(name, choice.names, 1);
        throw InputError(
            fmt::format("{}{} = {}", schema.where(key.path), key.path, toml_text(text)),
            fmt::format("{}known are {}{}", choice.several ? "'" + name + "' is unknown; " : "",
                        fmt::join(choice.names, ", "), choice.several ? ", with commas between" : ""),
            like.empty() ? "Use one of these." : fmt::format("Did you mean \"{}\"?", like.front()));
      }
      const std::size_t index = found - choice.names.begin();
      if (std::ranges::count(chosen, index) > 0)
        throw InputError(fmt::format("{}{} = {}", schema.where(key.path), key.path, toml_text(text)),
                         fmt::format("'{}' is named twice", name), "Name it once.");
      chosen.push_back(index);
    }
    choice.set(chosen);
  }

  void take(const Schema::Key& key, const toml::node& node, const TableList& list) {
    require_type(key, node, node.is_array_of_tables() || (node.is_array() && node.as_array()->empty()));
    list.clear();
    for (const toml::node& element : *node.as_array()) {
      Schema row = list.next();
      row.source_ = schema.source_;
      row.lines_[key.path] = static_cast<int>(element.source().begin.line);
      SchemaReader(row).table(*element.as_table(), key.path);
      row.require_needed();
    }
  }
};

std::optional<double> fraction_of(std::string_view text) {
  const auto skip_blanks = [&] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  };
  const auto number = [&]() -> std::optional<double> {
    if (text.empty() || !std::isdigit(static_cast<unsigned char>(text.front())))
      return std::nullopt;
    const std::string_view digits = text.substr(0, text.find_first_not_of("0123456789."));
    text.remove_prefix(digits.size());
    skip_blanks();
    return number_of_text(digits); // hundreds of digits are no number
  };
  skip_blanks();
  const bool negative = text.starts_with('-');
  text.remove_prefix(negative || text.starts_with('+') ? 1 : 0);
  const std::optional<double> above = number();
  if (!above || !(text.starts_with('/') || text.starts_with(':')))
    return std::nullopt;
  text.remove_prefix(1);
  skip_blanks();
  const std::optional<double> below = number();
  if (!below || !text.empty())
    return std::nullopt;
  const double value = (negative ? -*above : *above) / *below;
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

void require_text(std::string_view toml, std::string_view source_name, std::string_view what) {
  if (toml.starts_with("\x89HDF"))
    throw InputError(fmt::format("{} is no {}", source_name, what),
                     "it is an HDF5 file: a result file, or an influence file",
                     fmt::format("bem_contact info {} says what is in it.", source_name));
}

void Schema::read(std::string_view toml, std::string_view source_name) {
  source_ = source_name;
  lines_.clear();
  formerly_.clear();
  require_text(toml, source_name, title_);
  try {
    SchemaReader(*this).table(parse_toml(toml, source_name), "");
  } catch (const toml::parse_error& error) {
    const auto line = static_cast<std::size_t>(error.source().begin.line);
    const std::optional<double> fraction = fraction_in(line_of(toml, line));
    throw InputError(fmt::format("{}:{}: {}", source_name, line, error.description()),
                     fraction ? "TOML has no fractions" : "the file is not valid TOML",
                     fraction ? fmt::format("Write {:.6g}.", *fraction) : "Correct the line.");
  }
  require_needed();
  for (const Key& key : keys_)
    require_kind(key);
}

/// Remembers where the file has the key, under whichever name it stands at `path`.
void Schema::take_line(const Key& key, const std::string& path, int line) {
  if (path != key.path) {
    if (lines_.contains(key.path))
      refuse(key.path, fmt::format("{} is the same key under its former name", path), "Give one of them.");
    formerly_.insert(key.path);
  } else if (formerly_.contains(key.path))
    refuse(key.path, fmt::format("{} is the same key under its former name", key.rule.formerly),
           "Give one of them.");
  lines_[key.path] = line;
}

void Schema::set(const std::string& path, const SchemaValue& value, int line, const std::string& source) {
  const Key* key = find(path);
  if (source.empty())
    other_sources_.erase(key ? key->path : path);
  else
    other_sources_[key ? key->path : path] = source;
  if (!key) {
    lines_[path] = line;
    refuse_unknown(path, false);
  }
  lines_[key->path] = line;
  if (path != key->path)
    formerly_.insert(key->path);
  const auto assign = [&](const toml::node& node) { SchemaReader(*this).assign(*key, node); };
  std::visit(
      [&]<class T>(const T& given) {
        if constexpr (std::is_same_v<T, std::vector<double>>) {
          toml::array numbers;
          for (const double number : given)
            numbers.push_back(number);
          assign(numbers);
        } else
          assign(toml::value(given));
      },
      value);
  require_kind(*key);
}

} // namespace bem_contact
