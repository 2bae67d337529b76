#pragma once

#include "bem_contact/base/conventions.hpp"

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace bem_contact {

/// What is said of one key of a case file besides its name, type and default.
struct KeyRule {
  std::string doc;       ///< one line
  std::string unit = {}; ///< "" for none
  double at_least = -std::numeric_limits<double>::infinity();
  double above = -std::numeric_limits<double>::infinity();
  double at_most = std::numeric_limits<double>::infinity();
  double below = std::numeric_limits<double>::infinity();
  std::vector<std::string> choices = {}; ///< of a text; empty: any
  std::vector<std::string> kinds = {};   ///< kinds of file the key belongs to; empty: all
  bool* given = nullptr;                 ///< set to whether the file has the key
  bool needed = false;                   ///< the file must have it
  bool example = false;                  ///< no default: the printed value is an example
  bool alternative = false;              ///< says in another way what another key says: printed commented out
};

class Schema;

/// A key whose value is a list of tables: `next` appends an element and gives the schema bound to it.
struct TableList {
  std::function<void()> clear;
  std::function<Schema()> next;
  std::string example; ///< a list as TOML, for messages and print()
};

/// What a key is bound to.
using SchemaTarget =
    std::variant<double*, int*, bool*, std::string*, Point2*, std::vector<double>*, TableList>;

/// A value that stands for the one in the file.
using SchemaValue = std::variant<double, std::int64_t, bool, std::string>;

/// The schema of a TOML case file, bound to the members of one struct: one add() a key declares its name,
/// type, default (the member's value), unit, range and documentation, and is all that parsing, checking and
/// printing know of it.
class Schema {
public:
  /// `title`: what the file is, as in "a body file".
  explicit Schema(std::string title) : title_(std::move(title)) {}

  /// `path` is "table.key" or "key"; keys of one table are added one after the other.
  void add(std::string path, double& value, KeyRule rule) {
    add_key(std::move(path), &value, std::move(rule));
  }
  void add(std::string path, int& value, KeyRule rule) { add_key(std::move(path), &value, std::move(rule)); }
  void add(std::string path, bool& value, KeyRule rule) { add_key(std::move(path), &value, std::move(rule)); }
  void add(std::string path, std::string& value, KeyRule rule) {
    add_key(std::move(path), &value, std::move(rule));
  }
  void add(std::string path, Point2& value, KeyRule rule) {
    add_key(std::move(path), &value, std::move(rule));
  }
  /// A list of numbers; the rule's range holds for each.
  void add(std::string path, std::vector<double>& value, KeyRule rule) {
    add_key(std::move(path), &value, std::move(rule));
  }
  /// Keys of an element's schema have the path of the list before their names.
  void add(std::string path, TableList list, KeyRule rule) {
    add_key(std::move(path), std::move(list), std::move(rule));
  }
  /// A table that read() passes over: somebody else reads it.
  void skip(std::string table) { skipped_ = std::move(table); }
  /// The text key that tells the kind of file (KeyRule::kinds).
  void kind_is(std::string path) { kind_path_ = std::move(path); }

  /// Sets the bound members. Throws InputError naming source, line and key: not TOML, unknown key or table
  /// (with the nearest names), wrong type, not finite, out of range, a key of another kind of file.
  void read(std::string_view toml, std::string_view source_name);

  /// After read(): gives a key another value, as if line `line` of the file said so. Throws what read()
  /// would.
  void set(const std::string& path, const SchemaValue& value, int line);

  /// For checks across keys, after read(): whether the file has the key, and InputError at its line.
  bool has(std::string_view path) const { return lines_.contains(std::string(path)); }
  /// Whether the file gives the key another value than its default.
  bool changed(std::string_view path) const;
  [[noreturn]] void refuse(std::string_view path, std::string_view why, std::string_view what_to_do) const;

  /// Every key with its bound value, documented, as valid TOML. Keys of other kinds, alternatives, keys whose
  /// `given` is false and lists of tables (an example of them) are commented out.
  std::string print() const;

private:
  struct Key {
    std::string path;
    SchemaTarget target;
    KeyRule rule;
    std::string default_text; ///< as value_text() has it; of a list of tables: ""
  };
  void add_key(std::string path, SchemaTarget target, KeyRule rule);
  const Key* find(std::string_view path) const;
  bool belongs(const Key& key) const;
  void require_kind(const Key& key) const;
  void check(const Key& key) const;
  void require_needed() const;
  std::string where(std::string_view path) const;
  [[noreturn]] void refuse_unknown(const std::string& path, bool is_table) const;

  std::string title_, kind_path_, skipped_, source_;
  std::vector<Key> keys_;
  std::map<std::string, int> lines_; ///< of the keys and tables that the file has
  friend struct SchemaReader;
};

} // namespace bem_contact
