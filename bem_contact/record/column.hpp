#pragma once

#include "bem_contact/base/measured.hpp"
#include "bem_contact/record/record.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace bem_contact {

/// What a difference between two values of a quantity is measured by (sequence/compare_quantities.hpp).
enum class QuantityKind {
  other,
  force,
  moment,
  pressure,
  temperature,
  length,
  angle,
  area,
  creepage,
  power,
  share,
  count,
  effort ///< how the solver went: may differ where the result is the same
};

/// The unit of a number. What is per unit of rolled distance in rolling has another unit in a shift.
struct Unit {
  const char* rolling;         ///< in steady rolling, and of a transient; mm, N, MPa, rad; "1": none
  const char* shift = nullptr; ///< null: the same
  QuantityKind kind = QuantityKind::other; ///< for comparisons

  constexpr Unit(const char* all, const char* in_shift = nullptr, QuantityKind what = QuantityKind::other)
      : rolling(all), shift(in_shift), kind(what) {}

  /// Gives the unit that a result has.
  const char* of(bool is_shift) const { return shift && is_shift ? shift : rolling; }
  /// "1 (shift: mm)"
  std::string text() const {
    return shift ? std::string(rolling) + " (shift: " + shift + ")" : std::string(rolling);
  }
};

/// Whether a number may be nan: not every answer has one. Its meaning says when.
enum class Missing { never, possible };

/// What a function of a column takes: a result by reference, which patch by value.
template <class T> using ColumnArgument = std::conditional_t<std::is_scalar_v<T>, T, const T&>;

/// The column type of the project: one number of whatever `Of` is, with the name, the unit and the meaning
/// that all outputs give it. A quantity of a result is a ColumnOf<SceneResult>, one of a patch a
/// ColumnOf<SceneResult, std::size_t>.
template <class... Of> struct ColumnOf {
  const char* name; ///< in all outputs
  Unit unit;
  const char* meaning;                              ///< in a few words
  double (*value)(ColumnArgument<Of>...);           ///< nan: not known, or there is none
  double (*error)(ColumnArgument<Of>...) = nullptr; ///< in the same unit; null: none is ever stated
  int digits = 9;                                   ///< that are worth printing
  Missing missing = Missing::never;

  /// `Number`: a function, or a lambda without captures, that gives the number; a Measured where an error is
  /// stated for it.
  template <class Number>
  constexpr ColumnOf(const char* of_name, const Unit& of_unit, const char* what, Number number,
                     int worth_printing = 9)
      : name(of_name), unit(of_unit), meaning(what), value(value_of(number)), error(error_of(number)),
        digits(worth_printing) {}
  template <class Number>
  constexpr ColumnOf(const char* of_name, const Unit& of_unit, const char* what, Number number,
                     Missing may_be_missing)
      : ColumnOf(of_name, of_unit, what, number) {
    missing = may_be_missing;
  }

  /// Gives the number with its error.
  Measured measured(ColumnArgument<Of>... of) const {
    return {value(of...), error ? error(of...) : unknown_error};
  }

  /// One value a row, of a column of one kind of row.
  template <class Row> std::vector<double> values(std::span<const Row> rows) const {
    std::vector<double> out;
    out.reserve(rows.size());
    for (const Row& row : rows)
      out.push_back(value(row));
    return out;
  }
  template <class Row> std::vector<double> values(const std::vector<Row>& rows) const {
    return values(std::span<const Row>(rows));
  }

private:
  using Part = double (*)(ColumnArgument<Of>...);
  template <class Number>
  static constexpr bool states_error =
      std::is_same_v<std::invoke_result_t<Number, ColumnArgument<Of>...>, Measured>;

  template <class Number> static constexpr Part value_of(Number number) {
    static_assert(std::is_convertible_v<Number, Part> || std::is_empty_v<Number>, "it has captures");
    if constexpr (std::is_convertible_v<Number, Part>)
      return number;
    else
      return [](ColumnArgument<Of>... of) -> double { return Number{}(of...); };
  }
  template <class Number> static constexpr Part error_of(Number) {
    if constexpr (states_error<Number>)
      return [](ColumnArgument<Of>... of) { return Number{}(of...).error; };
    else
      return nullptr;
  }
};

/// The entry of a table with that name, which must be there.
template <class Columns> constexpr const auto& named(const Columns& columns, std::string_view name) {
  const auto found = std::ranges::find_if(columns, [&](const auto& column) { return name == column.name; });
  return found != std::ranges::end(columns) ? *found
                                            : throw std::out_of_range("there is no column of that name");
}

/// Lists the numbers of a table, and behind each its error, if it has one: use(name, unit, value, meaning,
/// error_of), where `value` is the function of the column. `error_of`: the name of the number that it is the
/// error of; "": it is none.
template <class Columns, class Use> void with_errors(const Columns& columns, const Use& use) {
  for (const auto& c : columns) {
    use(std::string(c.name), c.unit, c.value, c.meaning, std::string());
    if (c.error)
      use(record::error_name(c.name), c.unit, c.error, record::error_meaning, std::string(c.name));
  }
}

/// The numbers of a table in that order. `of`: what their functions take, as the result, and which patch.
template <class Columns, class... Of> std::vector<double> values_of(const Columns& columns, const Of&... of) {
  std::vector<double> values;
  with_errors(columns, [&](const std::string&, const Unit&, auto value, const char*, const std::string&) {
    values.push_back(value(of...));
  });
  return values;
}

namespace record {

/// Every number of one thing.
template <class Columns, class... Of>
Record numbers_of(const Columns& columns, bool is_shift, const Of&... of) {
  Record out;
  for (const auto& c : columns)
    out.add(c.name, Number{c.value(of...), c.unit.of(is_shift), c.meaning,
                           c.error ? std::optional(c.error(of...)) : std::nullopt,
                           c.unit.kind == QuantityKind::count});
  return out;
}

/// A table of `count` rows. `of(value, i)` calls the function of a column for a row.
template <class Columns, class Of>
Table table_of(std::string row, const Columns& columns, std::size_t count, bool is_shift, const Of& of) {
  Table out{std::move(row), {}, Layout::columns};
  for (const auto& c : columns) {
    const auto add = [&](std::string name, const char* meaning, auto value, int digits) -> Column& {
      Column& column = out.columns.emplace_back(Column{
          std::move(name), c.unit.of(is_shift), meaning, {}, c.unit.kind == QuantityKind::count, digits});
      column.values.reserve(count);
      for (std::size_t i = 0; i < count; ++i)
        column.values.push_back(of(value, i));
      return column;
    };
    add(c.name, c.meaning, c.value, c.digits);
    if (c.error) {
      Column& error = add(error_name(c.name), error_meaning, c.error, 3);
      error.role = Role::error;
      error.of = c.name;
    }
  }
  return out;
}

/// A table with a row of each of these.
template <class Columns, class Rows>
Table table_of(std::string row, const Columns& columns, const Rows& rows, bool is_shift = false) {
  return table_of(std::move(row), columns, rows.size(), is_shift,
                  [&](auto value, std::size_t i) { return value(rows[i]); });
}

} // namespace record

} // namespace bem_contact
