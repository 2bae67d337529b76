#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/enum_names.hpp"

#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bem_contact {

/// Everything about one key of a file besides its name, type, default and documentation.
struct KeyRule {
  std::string unit = {}; ///< "" for none
  double at_least = -std::numeric_limits<double>::infinity();
  double above = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  std::vector<std::string> kinds = {}; ///< kinds of file the key belongs to; empty: all
  bool needed = false;                 ///< the file must have it
  bool example = false;                ///< no default: print() shows the member's value as an example
  bool zero_is_none = false;           ///< of an optional number: 0 in the file means the same as no key
  /// print() writes the key as a comment. If a file does not have the key, other keys determine its value.
  bool commented_out = false;
  std::string formerly = {}; ///< path of the key in earlier versions; it is still read
};

class Schema;

/// A key whose value is a list of tables: `next` appends an element and gives the schema bound to it.
struct TableList {
  std::function<void()> clear;
  std::function<Schema()> next;
  std::string example; ///< a list as TOML, for messages and print()
  /// The schemas of the elements that are there, for print(); none: it shows the example alone.
  std::function<std::vector<Schema>()> rows = {};
};

/// A key with a fixed set of names, bound to an enum or a list of them: `text` is as the file writes it,
/// `set` takes indices into `names`.
struct NamedChoice {
  std::vector<std::string> names;
  std::function<std::string()> text;
  std::function<void(const std::vector<std::size_t>&)> set;
  bool several = false; ///< one name or more, with commas between, or as a list
};

/// What a key is bound to. An optional is empty if the file does not have the key (KeyRule::zero_is_none).
using SchemaTarget =
    std::variant<double*, int*, bool*, std::string*, Point2*, std::optional<double>*, std::optional<int>*,
                 std::optional<Point2>*, std::vector<double>*, NamedChoice, TableList>;

/// A value that takes the place of the one in the file. A list of numbers serves keys that are points, too.
using SchemaValue = std::variant<double, std::int64_t, bool, std::string, std::vector<double>>;

/// How a key is written.
enum class KeyType { number, whole_number, flag, text, point, numbers, choice, choices, tables };

/// All that a schema says of one key, for whoever lists keys: editors, pages.
struct KeyDescription {
  std::string path, doc; ///< "table.key"; one line
  KeyType type = KeyType::number;
  KeyRule rule = {};
  std::vector<std::string> choices = {};    ///< of a choice: the names; several stand with commas between
  std::optional<SchemaValue> value = {};    ///< default; nothing where other keys or nothing take its place
  std::vector<KeyDescription> columns = {}; ///< of tables: the keys of each
};

/// The schema of a TOML file, bound to the members of one struct.
///
/// One add() for each key declares its name, type, default (the member's value), unit, range and
/// documentation. Reading, checking and printing follow from that alone.
class Schema {
public:
  /// `title`: what the file is, as in "a body file".
  explicit Schema(std::string title) : title_(std::move(title)) {}

  /// `path` is "table.key" or "key"; keys of one table are added one after the other.
  /// Numbers, flags, texts, points and optionals of them; the range of the rule holds for each number.
  template <class T>
  requires std::constructible_from<SchemaTarget, T*>
  void add(std::string path, T& value, std::string doc, KeyRule rule = {}) {
    add_key(std::move(path), &value, std::move(doc), std::move(rule));
  }
  template <NamedEnum E> void add(std::string path, E& value, std::string doc, KeyRule rule = {}) {
    const auto& names = EnumNames<E>::names;
    add_key(std::move(path),
            NamedChoice{{names.begin(), names.end()},
                        [&value] { return std::string(name_of(value)); },
                        [&value](const auto& at) { value = static_cast<E>(at.front()); }},
            std::move(doc), std::move(rule));
  }
  template <NamedEnum E>
  void add(std::string path, std::vector<E>& values, std::string doc, KeyRule rule = {}) {
    std::vector<E> all(EnumNames<E>::names.size());
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<E>(i);
    add(std::move(path), values, std::move(all), std::move(doc), std::move(rule));
  }
  /// `allowed`: the values that the key takes.
  template <NamedEnum E>
  void add(std::string path, std::vector<E>& values, std::vector<E> allowed, std::string doc,
           KeyRule rule = {}) {
    std::vector<std::string> names;
    for (const E value : allowed)
      names.emplace_back(name_of(value));
    const auto set = [&values, allowed = std::move(allowed)](const auto& at) {
      values.clear();
      for (const std::size_t i : at)
        values.push_back(allowed[i]);
    };
    add_key(std::move(path), NamedChoice{std::move(names), [&values] { return names_of(values); }, set, true},
            std::move(doc), std::move(rule));
  }
  /// `none`: what the file writes for the empty optional.
  template <NamedEnum E>
  void add(std::string path, std::optional<E>& value, std::string none, std::string doc, KeyRule rule = {}) {
    NamedChoice choice{{none},
                       [&value, none] { return value ? std::string(name_of(*value)) : none; },
                       [&value](const auto& at) {
                         value =
                             at.front() > 0 ? std::optional(static_cast<E>(at.front() - 1)) : std::nullopt;
                       }};
    choice.names.insert(choice.names.end(), EnumNames<E>::names.begin(), EnumNames<E>::names.end());
    add_key(std::move(path), std::move(choice), std::move(doc), std::move(rule));
  }
  /// Some of these names. `none`: what the file writes for the empty list.
  void add(std::string path, std::vector<std::string>& values, std::vector<std::string> names,
           std::string none, std::string doc, KeyRule rule = {});
  /// A list of tables. The schema of one table in the list declares each key with the list's path in front:
  /// for the list "body.holes" that is "body.holes.radius".
  void add(std::string path, TableList list, std::string doc, KeyRule rule = {}) {
    add_key(std::move(path), std::move(list), std::move(doc), std::move(rule));
  }
  /// read() ignores this table, because other code reads it.
  void skip(std::string table) { skipped_.insert(std::move(table)); }
  /// read() ignores keys of this table that are not declared, because other code reads and checks them.
  void share(std::string table) { shared_.insert(std::move(table)); }
  /// The key that says which kind of file it is (KeyRule::kinds); it is bound to an enum.
  void kind_is(std::string path) { kind_path_ = std::move(path); }

  /// Sets the bound members. Throws InputError naming source, line and key: not TOML, unknown key or table
  /// (with the nearest names), wrong type, not finite, out of range, a key of another kind of file.
  void read(std::string_view toml, std::string_view source_name);

  /// Gives a key another value after read(), as if line `line` of the file said so, or of another `source`.
  /// Throws what read() would.
  void set(const std::string& path, const SchemaValue& value, int line, const std::string& source = "");
  /// A number as the key takes it: whole for a key of whole numbers, true for 1 and false for 0 of a flag.
  /// For languages that have one kind of number. Throws InputError for an unknown key, with the nearest
  /// names.
  SchemaValue number_for(const std::string& path, double number) const;

  /// Says after read() whether the file has the key. Checks across keys use it.
  bool has(std::string_view path) const { return lines_.contains(std::string(path)); }
  /// The keys that the file gives under the name of an earlier version, in sentences.
  std::vector<std::string> former_names() const;
  /// Says whether the file gives the key another value than its default.
  bool changed(std::string_view path) const;
  [[noreturn]] void refuse(std::string_view path, std::string_view why, std::string_view what_to_do) const;

  /// Returns the keys of a table, without its name.
  std::vector<std::string> keys_of(std::string_view table) const;

  /// Returns the unit of the key, "" for none and for a key that is not there.
  std::string unit(std::string_view path) const;

  /// Every key, in the order of add().
  std::vector<KeyDescription> describe() const;

  /// Every key with its bound value, documented, as valid TOML. Commented out are keys of other kinds,
  /// optionals without a value, lists of tables (an example of them) and what its rule says. The elements of
  /// lists of tables stand at the end.
  std::string print() const;

private:
  struct Key {
    std::string path;
    std::string doc; ///< one line
    SchemaTarget target;
    KeyRule rule;
    std::string default_text; ///< as value_text() has it; of a list of tables: ""
  };
  void add_key(std::string path, SchemaTarget target, std::string doc, KeyRule rule);
  const Key* find(std::string_view path) const;
  bool belongs(const Key& key) const;
  void require_kind(const Key& key) const;
  void check(const Key& key) const;
  void require_needed() const;
  void take_line(const Key& key, const std::string& path, int line);
  std::string where(std::string_view path) const;
  [[noreturn]] void refuse_unknown(const std::string& path, bool is_table) const;

  std::string title_, kind_path_, source_;
  std::set<std::string> skipped_, shared_;
  std::vector<Key> keys_;
  std::map<std::string, int> lines_;                 ///< of the keys and tables that the file has
  std::map<std::string, std::string> other_sources_; ///< of the keys that another file gives
  std::set<std::string> formerly_;                   ///< those of them that it gives under their former name
  friend class SchemaReader;
};

/// Adds keys of one table: their paths begin with its name, and they belong to the same kinds of file unless
/// their rules name others.
class SchemaTable {
public:
  SchemaTable(Schema& schema, std::string name, std::vector<std::string> kinds = {})
      : schema_(schema), name_(std::move(name)), kinds_(std::move(kinds)) {}

  /// Does what Schema::add() does.
  template <class Value> void add(const std::string& key, Value&& value, std::string doc, KeyRule rule = {}) {
    schema_.add(name_ + "." + key, std::forward<Value>(value), std::move(doc), of_kinds(std::move(rule)));
  }
  template <NamedEnum E>
  void add(const std::string& key, std::vector<E>& values, std::vector<E> allowed, std::string doc,
           KeyRule rule = {}) {
    schema_.add(name_ + "." + key, values, std::move(allowed), std::move(doc), of_kinds(std::move(rule)));
  }
  template <NamedEnum E>
  void add(const std::string& key, std::optional<E>& value, std::string none, std::string doc,
           KeyRule rule = {}) {
    schema_.add(name_ + "." + key, value, std::move(none), std::move(doc), of_kinds(std::move(rule)));
  }

private:
  KeyRule of_kinds(KeyRule rule) const {
    if (rule.kinds.empty())
      rule.kinds = kinds_;
    return rule;
  }

  Schema& schema_;
  std::string name_;
  std::vector<std::string> kinds_;
};

/// 0.025 of "1/40" and "1:40", which TOML does not know; nothing of any other text.
std::optional<double> fraction_of(std::string_view text);

/// Throws InputError where a file that should be a `what` (TOML) is an HDF5 file.
void require_text(std::string_view toml, std::string_view source_name, std::string_view what);

} // namespace bem_contact
