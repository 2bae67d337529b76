#include "bem_contact/c/result_values.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>
#include <tuple>

namespace bem_contact {

namespace {

/// The names of sequence/quantities.hpp in the order of conformal_contact.h.
constexpr std::array<const char*, CONFORMAL_TOTALS> total_names{
    "Fx",         "Fy",   "Fz",   "Fs",      "Mz",          "approach",      "creepage_x",
    "creepage_s", "pmax", "area", "T_gamma", "certificate", "discretisation"};
constexpr std::array<const char*, CONFORMAL_PATCH_VALUES> patch_names{
    "Fn",          "Fx",          "Fs",         "overlap",     "pmax", "area",  "x",      "s",
    "contact",     "adhesion",    "slip",       "Fy",          "Fz",   "Mx",    "Ms",     "Mn",
    "semi_axis_a", "semi_axis_b", "axis_angle", "y",           "z",    "delta", "rail_y", "rail_z",
    "wheel_s",     "wheel_y",     "wheel_z",    "wheel_delta", "xi",   "eta",   "phi",    "T_gamma"};
constexpr std::array<const char*, CONFORMAL_STATE + 1> array_names{
    "x",    "s",   "y",   "z",      "delta",
    "p_x",  "p_s", "p_n", "slip_x", "slip_s",
    "u_x",  "u_s", "u_n", "gap",    "deformed_distance",
    "state"};

/// The entries of those names.
template <class Table, std::size_t n>
auto entries(const Table& table, const std::array<const char*, n>& names) {
  std::array<const typename Table::value_type*, n> out{};
  for (std::size_t i = 0; i < n; ++i)
    out[i] = &named(table, names[i]);
  return out;
}

// Looked up once, because callers ask at each time step.
const auto& totals() {
  static const auto all = entries(quantities(), total_names);
  return all;
}
const auto& patch_numbers() {
  static const auto all = entries(patch_quantities(), patch_names);
  return all;
}

/// `of`: the result, and which patch.
template <class Entries, class... Of> auto values_of_entries(const Entries& all, const Of&... of) {
  std::array<double, std::tuple_size_v<Entries>> out{};
  std::ranges::transform(all, out.begin(), [&](const auto* entry) { return entry->value(of...); });
  return out;
}
template <class Entries, class... Of> auto errors_of_entries(const Entries& all, const Of&... of) {
  std::array<double, std::tuple_size_v<Entries>> out{};
  std::ranges::transform(all, out.begin(), [&](const auto* entry) { return entry->measured(of...).error; });
  return out;
}

} // namespace

std::array<double, CONFORMAL_TOTALS> totals_of(const SceneResult& result) {
  auto out = values_of_entries(totals(), result);
  if (std::isnan(out[CONFORMAL_DISCRETISATION]))
    out[CONFORMAL_DISCRETISATION] = -1;
  return out;
}

std::array<double, CONFORMAL_PATCH_VALUES> values_of(const SceneResult& result, std::size_t patch) {
  return values_of_entries(patch_numbers(), result, patch);
}

std::array<double, CONFORMAL_TOTALS> total_errors_of(const SceneResult& result) {
  return errors_of_entries(totals(), result);
}

std::array<double, CONFORMAL_PATCH_VALUES> errors_of(const SceneResult& result, std::size_t patch) {
  return errors_of_entries(patch_numbers(), result, patch);
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
    throw InputError(
        fmt::format("The array {} does not fit into {}", which, counted(to.size(), "value", "values")),
        fmt::format("it has {}: the grid is mx = {} by ms = {}", size, grid.mx, grid.ms),
        "Ask conformal_grid() after each solution.");
  const char* name = array_names[static_cast<std::size_t>(which)];
  if (which == CONFORMAL_X) {
    for (int ix = 0; ix < grid.mx; ++ix)
      to[static_cast<std::size_t>(ix)] = grid.x(ix);
  } else if (which <= CONFORMAL_DELTA) {
    for (std::size_t row = 0; row < to.size(); ++row)
      to[row] = named(row_quantities(), name).value(result, row);
  } else {
    named(element_quantities(), name).copy(result, to);
  }
}

} // namespace bem_contact
