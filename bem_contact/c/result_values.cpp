#include "bem_contact/c/result_values.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace bem_contact {

namespace {

/// The names of sequence/quantities.hpp in the order of conformal_contact.h.
constexpr std::array<const char*, CONFORMAL_TOTALS> total_names{"Fx",
                                                                "Fy",
                                                                "Fz",
                                                                "Fs",
                                                                "Mz",
                                                                "approach",
                                                                "creepage_x",
                                                                "creepage_s",
                                                                "pmax",
                                                                "area",
                                                                "friction_power",
                                                                "certificate",
                                                                "discretisation"};
constexpr std::array<const char*, CONFORMAL_PATCH_VALUES> patch_names{
    "Fn",          "Fx",          "Fs",         "approach",    "pmax", "area",  "x",      "s",
    "contact",     "adhesion",    "slip",       "Fy",          "Fz",   "Mx",    "Ms",     "Mn",
    "semi_axis_a", "semi_axis_b", "axis_angle", "y",           "z",    "delta", "rail_y", "rail_z",
    "wheel_s",     "wheel_y",     "wheel_z",    "wheel_delta", "xi",   "eta",   "phi",    "friction_power"};
constexpr std::array<const char*, CONFORMAL_STATE + 1> array_names{
    "x",    "s",   "y",   "z",      "delta",
    "p_x",  "p_s", "p_n", "slip_x", "slip_s",
    "u_x",  "u_s", "u_n", "gap",    "deformed_distance",
    "state"};

/// The entry of a table with that name.
template <class Table> const auto& named(const Table& table, std::string_view name) {
  return *std::ranges::find_if(table, [&](const auto& entry) { return name == entry.name; });
}

/// The entries of those names: looked up once, because callers ask at each time step.
template <class Table, std::size_t n>
auto entries(const Table& table, const std::array<const char*, n>& names) {
  std::array<const typename Table::value_type*, n> out{};
  for (std::size_t i = 0; i < n; ++i)
    out[i] = &named(table, names[i]);
  return out;
}

} // namespace

std::array<double, CONFORMAL_TOTALS> totals_of(const SceneResult& result) {
  static const auto totals = entries(quantities(), total_names);
  std::array<double, CONFORMAL_TOTALS> out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = totals[i]->value(result);
  if (std::isnan(out[CONFORMAL_DISCRETISATION]))
    out[CONFORMAL_DISCRETISATION] = -1;
  return out;
}

std::array<double, CONFORMAL_PATCH_VALUES> values_of(const SceneResult& result, std::size_t patch) {
  static const auto numbers = entries(patch_quantities(), patch_names);
  std::array<double, CONFORMAL_PATCH_VALUES> out{};
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = numbers[i]->value(result, patch);
  return out;
}

void copy_first(std::span<const double> values, double* to, int count) {
  if (count < 0 || count > static_cast<int>(values.size()))
    throw InputError(fmt::format("{} values cannot be copied", count),
                     fmt::format("there are {}", values.size()),
                     "Give the size of the array, at most the number of values.");
  std::copy_n(values.begin(), count, to);
}

void copy_array(const SceneResult& result, int which, std::span<double> to) {
  const ContactGrid& grid = result.problem.grid;
  if (which < CONFORMAL_X || which > CONFORMAL_STATE)
    throw InputError(fmt::format("There is no array {}", which),
                     fmt::format("they have the numbers {} to {}", CONFORMAL_X, CONFORMAL_STATE),
                     "See CONFORMAL_X and the following in conformal_contact.h.");
  const int size = which == CONFORMAL_X ? grid.mx : which <= CONFORMAL_DELTA ? grid.ms : grid.size();
  if (to.size() != static_cast<std::size_t>(size))
    throw InputError(fmt::format("The array {} does not fit into {} values", which, to.size()),
                     fmt::format("it has {}: the grid is mx = {} by ms = {}", size, grid.mx, grid.ms),
                     "Ask conformal_grid() after each solution.");
  const char* name = array_names[static_cast<std::size_t>(which)];
  if (which == CONFORMAL_X) {
    for (int ix = 0; ix < grid.mx; ++ix)
      to[static_cast<std::size_t>(ix)] = grid.x(ix);
  } else if (which <= CONFORMAL_DELTA) {
    const RowQuantity& row = named(row_quantities(), name);
    for (std::size_t is = 0; is < to.size(); ++is)
      to[is] = row.value(result, is);
  } else {
    named(element_quantities(), name).copy(result, to);
  }
}

} // namespace bem_contact
