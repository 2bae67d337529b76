#include "bem_contact/uses/table/packed_table.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/table/conformal_packed_table.h"

#include <fmt/format.h>
#include <iterator>
#include <string_view>

namespace bem_contact::table {

extern const char* const packed_functions; // conformal_packed_table.h; the build writes it

namespace {

std::vector<const Column*> columns_of(const ContactTable& table, std::span<const std::string> names) {
  std::vector<const Column*> out;
  for (const std::string& name : names)
    out.push_back(&table.column(name));
  if (names.empty())
    for (const Column& column : table.columns)
      out.push_back(&column);
  return out;
}

void require_packable(const ContactTable& table, std::size_t columns) {
  const auto refuse = [](const std::string& why, const char* what_to_do) {
    throw InputError("The table cannot be packed", why, what_to_do);
  };
  if (table.nested())
    refuse("it has the creep forces of ellipses, whose axes are nested",
           "Pack a table of a scene, or look this one up with conformal_table_creep_forces().");
  if (table.axes.size() > CONFORMAL_PACKED_MOST_AXES)
    refuse(fmt::format("it has {}, and {} are possible", counted(std::ssize(table.axes), "axis", "axes"),
                       CONFORMAL_PACKED_MOST_AXES),
           "Make one with fewer.");
  if (columns > CONFORMAL_PACKED_MOST_COLUMNS)
    refuse(fmt::format("{} are asked for, and {} are possible",
                       counted(std::ptrdiff_t(columns), "column", "columns"), CONFORMAL_PACKED_MOST_COLUMNS),
           "Name fewer.");
}

/// Lines of at most so many numbers.
void print_numbers(std::string& out, std::span<const double> numbers) {
  constexpr std::size_t in_a_line = 6;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool known = numbers[i] == numbers[i];
    fmt::format_to(std::back_inserter(out), "{}{}{}",
                   known ? fmt::format("{:.17g}", numbers[i]) : "CONFORMAL_PACKED_NAN",
                   i + 1 < numbers.size() ? "," : "", (i + 1) % in_a_line == 0 ? "\n" : " ");
  }
}

void print_names(std::string& out, const char* name, const std::vector<std::string>& names) {
  out += fmt::format("static const char* const {}[] = {{", name);
  for (std::size_t i = 0; i < names.size(); ++i)
    out += fmt::format("{}\"{}\"", i > 0 ? ", " : "", names[i]);
  out += "};\n";
}

} // namespace

std::vector<double> packed(const ContactTable& table, std::span<const std::string> columns) {
  const std::vector<const Column*> taken = columns_of(table, columns);
  require_packable(table, taken.size());
  std::vector<double> out{CONFORMAL_PACKED_MARK, CONFORMAL_PACKED_LAYOUT, 0, double(table.axes.size()),
                          double(taken.size())};
  for (const Axis& axis : table.axes)
    out.push_back(double(axis.points.size()));
  for (const Axis& axis : table.axes)
    out.insert(out.end(), axis.points.begin(), axis.points.end());
  for (const Column* column : taken)
    out.push_back(column->error());
  for (std::size_t i = 0; i < table.size(); ++i)
    for (const Column* column : taken)
      out.push_back(column->values[i]);
  out[2] = double(out.size());
  return out;
}

std::string packed_source(const ContactTable& table, std::span<const std::string> columns) {
  const std::vector<double> numbers = packed(table, columns);
  std::vector<std::string> axes, names;
  for (const Axis& axis : table.axes)
    axes.push_back(fmt::format("{}, {}", axis.name, axis.unit));
  for (const Column* column : columns_of(table, columns))
    names.push_back(fmt::format("{}, {}", column->name, column->unit));
  std::string out = packed_functions;
  out += "\n/* A quiet nan without <math.h>: what is not known. */\n#define CONFORMAL_PACKED_NAN (1e300 * "
         "1e300 - 1e300 * "
         "1e300)\n\n/* \"NAME, UNIT\", in their order. */\n";
  print_names(out, "conformal_packed_axes", axes);
  print_names(out, "conformal_packed_columns", names);
  out += fmt::format("static const double conformal_packed[{}] = {{\n", numbers.size());
  print_numbers(out, numbers);
  return out + "};\n";
}

PackedForces look_up(const ContactTable& table, std::span<const double> packed, std::span<const double> at) {
  require_coordinates(table, at.size());
  const auto columns = static_cast<std::size_t>(packed[4]);
  PackedForces out{std::vector<double>(columns), std::vector<double>(columns),
                   std::vector<double>(columns * at.size())};
  int beyond = 0;
  if (conformal_packed_force(packed.data(), at.data(), int(columns), out.values.data(),
                             out.derivatives.data(), out.errors.data(), &beyond) == CONFORMAL_PACKED_BEYOND) {
    const auto axis = static_cast<std::size_t>(beyond < 0 ? -beyond : beyond) - 1;
    require_inside(table.axes[axis], at[axis]);
  }
  return out;
}

} // namespace bem_contact::table
