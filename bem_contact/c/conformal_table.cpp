#include "bem_contact/c/calls.hpp"
#include "bem_contact/uses/table/conformal_packed_table.h"
#include "bem_contact/uses/table/creep_table.hpp"
#include "bem_contact/uses/table/packed_table.hpp"
#include "bem_contact/uses/table/table_file.hpp"

#include <fmt/format.h>

#include <array>

using namespace bem_contact;

/// What a handle points to; nothing changes it.
struct conformal_table {
  const table::ContactTable table;
  const std::vector<double> packed; ///< of conformal_table_force(); empty: it cannot be packed
};
static_assert(CONFORMAL_OK == CONFORMAL_PACKED_OK && CONFORMAL_WRONG_INPUT == CONFORMAL_PACKED_WRONG &&
              CONFORMAL_BEYOND_TABLE == CONFORMAL_PACKED_BEYOND);

namespace {

/// The member of a list, or a null pointer.
template <class Member> const Member* member(const std::vector<Member>& all, int index) {
  return index >= 0 && index < static_cast<int>(all.size()) ? &all[static_cast<std::size_t>(index)] : nullptr;
}

/// The columns of a table that can be packed, as many as there is room for.
std::vector<double> packed_if_possible(const table::ContactTable& t) {
  if (t.nested() || t.axes.size() > CONFORMAL_PACKED_MOST_AXES)
    return {};
  std::vector<std::string> names;
  for (const table::Column& column : t.columns)
    if (names.size() < CONFORMAL_PACKED_MOST_COLUMNS)
      names.push_back(column.name);
  return table::packed(t, names);
}

template <class Value, class From> void give(Value* to, const From& value) {
  if (to)
    *to = value;
}

} // namespace

extern "C" {

int conformal_table_open(const char* file, conformal_table** handle, char* message, int size) {
  return told(message, size, [&] {
    require(handle, "the handle");
    *handle = nullptr;
    require(file, "the name of the table");
    table::ContactTable read = table::read_table(file);
    std::vector<double> packed = packed_if_possible(read);
    *handle = new conformal_table{std::move(read), std::move(packed)};
  });
}

void conformal_table_close(conformal_table* handle) {
  delete handle;
}

int conformal_table_size(const conformal_table* handle, int* axes, int* columns) {
  if (!handle || !axes || !columns)
    return CONFORMAL_WRONG_INPUT;
  *axes = static_cast<int>(handle->table.axes.size());
  *columns = static_cast<int>(handle->table.columns.size());
  return CONFORMAL_OK;
}

int conformal_table_axis(const conformal_table* handle, int index, const char** name, const char** unit,
                         double* from, double* to) {
  const table::Axis* axis = handle ? member(handle->table.axes, index) : nullptr;
  if (!axis)
    return CONFORMAL_WRONG_INPUT;
  give(name, axis->name.c_str());
  give(unit, axis->unit.c_str());
  give(from, axis->points.front());
  give(to, axis->points.back());
  return CONFORMAL_OK;
}

int conformal_table_column(const conformal_table* handle, int index, const char** name, const char** unit,
                           double* error) {
  const table::Column* column = handle ? member(handle->table.columns, index) : nullptr;
  if (!column)
    return CONFORMAL_WRONG_INPUT;
  give(name, column->name.c_str());
  give(unit, column->unit.c_str());
  give(error, column->error());
  return CONFORMAL_OK;
}

int conformal_table_find(const conformal_table* handle, const char* name, int* column) {
  if (!handle || !name || !column)
    return CONFORMAL_WRONG_INPUT;
  const std::vector<table::Column>& all = handle->table.columns;
  const auto found = std::ranges::find(all, name, &table::Column::name);
  if (found == all.end())
    return CONFORMAL_WRONG_INPUT;
  *column = static_cast<int>(found - all.begin());
  return CONFORMAL_OK;
}

int conformal_table_look_up(const conformal_table* handle, const double* at, int axes, double* values,
                            double* errors, int columns, char* message, int size) {
  return told(message, size, [&] {
    require(handle && at && values, "the table, the point or the array");
    const table::ContactTable& t = handle->table;
    if (columns < 0 || columns > static_cast<int>(t.columns.size()))
      throw InputError(fmt::format("{} columns cannot be looked up", columns),
                       fmt::format("the table has {}", t.columns.size()),
                       "Count them with conformal_table_size().");
    const std::vector<double> found =
        table::look_up(t, {at, static_cast<std::size_t>(std::max(axes, 0))}); // of all: a call is no loop
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c) {
      values[c] = found[c];
      if (errors)
        errors[c] = t.columns[c].error();
    }
  });
}

int conformal_table_force(const conformal_table* handle, const double* at, int columns, double* values,
                          double* derivatives, double* errors, int* beyond) {
  if (!handle || handle->packed.empty())
    return CONFORMAL_WRONG_INPUT;
  return conformal_packed_force(handle->packed.data(), at, columns, values, derivatives, errors, beyond);
}

int conformal_table_creep_forces(const conformal_table* handle, const double ellipse[7], double forces[3],
                                 double errors[3], char* message, int size) {
  return told(message, size, [&] {
    require(handle && ellipse && forces, "the table, the ellipse or the array");
    const table::TabulatedForces f = table::creep_forces(
        handle->table,
        {ellipse[CONFORMAL_ELLIPSE_A], ellipse[CONFORMAL_ELLIPSE_B], ellipse[CONFORMAL_ELLIPSE_MODULUS],
         ellipse[CONFORMAL_ELLIPSE_BOUND]},
        ellipse[CONFORMAL_ELLIPSE_XI], ellipse[CONFORMAL_ELLIPSE_ETA], ellipse[CONFORMAL_ELLIPSE_PHI]);
    std::ranges::copy(std::array{f.Fx, f.Fy, f.Mz}, forces);
    if (errors)
      std::ranges::copy(std::array{f.Fx_error, f.Fy_error, f.Mz_error}, errors);
  });
}

} // extern "C"
