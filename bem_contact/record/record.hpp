#pragma once

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/base/error.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// What an answer says, whoever asks: a tree of named values. It knows nothing of physics. Each answer (a
/// result, a comparison, a wheelset ...) has one function that makes its record. Each format (JSON, HDF5,
/// CSV, text, Python, C) has one writer, which takes any record. So a name is the same number everywhere.
namespace bem_contact::record {

/// A number. Where an error is stated for numbers of its kind, it is there too, in the same unit; nan: it is
/// not known. Formats without a place for it write it as NAME_error.
struct Number {
  double value = 0;                    ///< nan: not known, or there is none
  std::string unit = {}, meaning = {}; ///< mm, N, MPa ..., "1": none; in a few words
  std::optional<double> error = {};    ///< nothing: none is ever stated
  bool whole = false;                  ///< a count
};

/// A text. One with a meaning may be long; HDF5 keeps it as a dataset, the others as attributes.
struct Text {
  std::string text;
  std::string meaning = {};
};

/// What a page or a picture does with numbers, beyond showing them.
enum class Role {
  other,
  swept,   ///< a key that a sweep varies
  carried, ///< a column that a sweep's table carries along
  outcome, ///< how cases ended: record::Outcome, which the choices name
  // These belong to other numbers, which `of` names:
  error,      ///< what those are estimated to be off, in their unit
  right,      ///< those of the right wheel
  left,       ///< those of the left wheel
  of_run,     ///< as a vehicle program's own contact model has them
  difference, ///< that less them
};

/// Several texts, such as warnings.
struct Texts {
  std::vector<std::string> lines;
  std::string meaning;
};

/// Numbers in one or more dimensions, row-major. They are looked at, not copied: `owner` keeps them alive.
struct Field {
  std::string unit, meaning;
  std::vector<std::size_t> shape; ///< length of each dimension
  std::span<const double> values; ///< as many as the product of the lengths, the last dimension fastest
  std::shared_ptr<const void> owner = nullptr; ///< nothing: whoever made the record keeps them
  Role role = Role::other;
  std::vector<std::string> choices = {}; ///< the values count these, from 0; empty: they are numbers
  std::string of = {};                   ///< a name in the same group, where the role asks for one
};
/// A field that owns its values. No shape: one dimension.
Field field(std::vector<double> values, std::string unit, std::string meaning,
            std::vector<std::size_t> shape = {});

/// One column of a table.
struct Column {
  std::string name = {}, unit = {}, meaning = {};
  std::vector<double> values = {}; ///< one a row; nan: not known
  bool whole = false;              ///< counts
  int digits = 9;                  ///< that are worth printing
  Role role = Role::other;
  std::string of = {}; ///< a column of the same table, where the role asks for one
};

/// How JSON and Python write a table: a list of rows, or an object of columns.
enum class Layout { rows, columns };

/// Columns of equal length.
struct Table {
  std::string row; ///< what each row is: "patch"
  std::vector<Column> columns = {};
  Layout layout = Layout::columns;

  std::size_t size() const { return columns.empty() ? 0 : columns.front().values.size(); } ///< rows
  const Column* column(std::string_view name) const;                                       ///< null: none
};

/// The same with the layout of what people count: patches, steps.
inline Table as_rows(Table table) {
  table.layout = Layout::rows;
  return table;
}

struct Entry;

/// Named values in the order of their writing.
class Record {
public:
  Record() = default;
  Record(std::initializer_list<Entry> entries);

  using Nothing = std::monostate; ///< a part that this answer does not have
  template <class Content> Record& add(std::string name, Content content);
  /// Adds all entries of another one.
  Record& append(Record other);

  const std::vector<Entry>& entries() const { return entries_; }
  bool empty() const { return entries_.empty(); }

private:
  std::vector<Entry> entries_;
};

using Content = std::variant<std::monostate, bool, Number, Text, Texts, Field, Table, Record>;

/// A value and its name.
struct Entry {
  std::string name;
  Content content;
};

inline Record::Record(std::initializer_list<Entry> entries) : entries_(entries) {}

template <class T> Record& Record::add(std::string name, T content) {
  if constexpr (std::is_convertible_v<T, std::string>)
    entries_.push_back({std::move(name), Text{std::string(std::move(content))}});
  else
    entries_.push_back({std::move(name), Content(std::move(content))});
  return *this;
}

/// "Fx_error"
std::string error_name(std::string_view name);
/// What an error is, in a few words.
inline constexpr const char* error_meaning = "estimated error by the size of the elements; nan: not known";

/// What stands at a path, "structure/rail/force"; null where there is no such entry. A path ends at a table.
const Content* find(const Record& record, std::string_view path);
/// The number at a path: of a number, its error ("quantities/Fx_error"), an entry of a table's row
/// ("patches/0/Fn"; rows from 0), a yes or no (1 or 0), or an entry of a field of one dimension. Nothing
/// where there is no number.
std::optional<double> number_at(const Record& record, std::string_view path);
/// The text at a path.
std::optional<std::string_view> text_at(const Record& record, std::string_view path);
/// The yes or no at a path.
std::optional<bool> flag_at(const Record& record, std::string_view path);
/// All numbers at a path: of a field, or of a table's column ("patches/Fn"). Empty where there are none.
std::span<const double> values_at(const Record& record, std::string_view path);
/// Whether any of these finds something there.
bool has(const Record& record, std::string_view path);
/// Every path that has() finds, of tables and fields in their first row.
std::vector<std::string> paths_of(const Record& record);
/// What to say where has() is false: it names the paths most like this one. `what`: "result".
InputError unknown_path(const Record& record, std::string_view path, std::string_view what);

} // namespace bem_contact::record

template <> struct bem_contact::EnumNames<bem_contact::record::Role> {
  static constexpr std::array<std::string_view, 9> names{"",      "swept", "carried", "outcome",   "error",
                                                         "right", "left",  "of_run",  "difference"};
};
