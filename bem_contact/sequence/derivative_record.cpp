#include "bem_contact/sequence/derivative_record.hpp"

#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

using record::Number;
using record::Record;

/// Nothing where it is not bounded.
Number reach(double step, const std::string& unit, const char* meaning) {
  return {std::isfinite(step) ? step : std::numeric_limits<double>::quiet_NaN(), unit, meaning};
}

record::Table patches_of(const InputDerivatives& input) {
  record::Table out{.row = "patch", .layout = record::Layout::rows};
  for (std::size_t k = 0; k < derived_patch_numbers().size(); ++k) {
    const PatchQuantity& q = named(patch_quantities(), derived_patch_numbers()[k]);
    record::Column column{q.name, unit_per(q.unit.of(false), input.unit), q.meaning};
    for (const std::vector<double>& patch : input.patches)
      column.values.push_back(patch[k]);
    out.columns.push_back(std::move(column));
  }
  return out;
}

Record record_of(const InputDerivatives& input) {
  Record out;
  out.add("key", input.key);
  for (std::size_t k = 0; k < derived_totals().size(); ++k)
    if (const Quantity& q = quantity(derived_totals()[k]); !std::isnan(input.totals[k]))
      out.add(q.name, Number{input.totals[k], unit_per(q.unit.of(false), input.unit), q.meaning});
  out.add("patches", patches_of(input));
  out.add("below", reach(input.below, input.unit,
                         "it may be so much smaller until an element changes its state; nan: any"));
  out.add("at_below", std::string(name_of(input.at_below)));
  out.add("above", reach(input.above, input.unit,
                         "it may be so much larger until an element changes its state; nan: any"));
  out.add("at_above", std::string(name_of(input.at_above)));
  return out;
}

/// A row for each point.
Record record_of(const ProfileDerivatives& profile) {
  record::Table table{.row = "point", .layout = record::Layout::columns};
  const auto add = [&](std::string name, std::string unit, std::string meaning, const auto& value) {
    record::Column column{std::move(name), std::move(unit), std::move(meaning)};
    for (std::size_t k = 0; k < profile.points.size(); ++k)
      column.values.push_back(value(k));
    table.columns.push_back(std::move(column));
  };
  add("s", "mm", "arc length", [&](std::size_t k) { return profile.points[k].s; });
  add("y", "mm", "in the frame of the profile", [&](std::size_t k) { return profile.points[k].position.y; });
  add("z", "mm", "likewise, down", [&](std::size_t k) { return profile.points[k].position.z; });
  for (std::size_t n = 0; n < derived_totals().size(); ++n) {
    const Quantity& q = quantity(derived_totals()[n]);
    if (std::ranges::none_of(profile.by_point, [&](const auto& at) { return std::isnan(at.totals[n]); }))
      add(q.name, unit_per(q.unit.of(false), "mm"), q.meaning,
          [&](std::size_t k) { return profile.by_point[k].totals[n]; });
  }
  return Record{{"points", std::move(table)}};
}

} // namespace

std::string unit_per(std::string_view unit, std::string_view input) {
  if (input == "1")
    return std::string(unit);
  if (unit == input)
    return "1";
  if (input.starts_with("1/"))
    return unit == "1" ? std::string(input.substr(2)) : fmt::format("{} {}", unit, input.substr(2));
  const bool compound = input.find_first_of(" /") != std::string_view::npos;
  return fmt::format(fmt::runtime(compound ? "{}/({})" : "{}/{}"), unit, input);
}

Record derivatives_of(const SceneResult& result) {
  Record out;
  for (const InputDerivatives& input : result.derivatives)
    out.add(input.name, record_of(input));
  for (const ProfileDerivatives& profile : result.profile_derivatives)
    out.add(profile.name, record_of(profile));
  return out;
}

} // namespace bem_contact
