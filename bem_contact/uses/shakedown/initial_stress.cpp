#include "bem_contact/uses/shakedown/initial_stress.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/place_in_table.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace bem_contact::shakedown {

using halfspace::Stress;

namespace {

struct NamedComponent {
  std::string_view name;
  double Stress::*value;
};
constexpr NamedComponent components[] = {{"xx", &Stress::xx}, {"ss", &Stress::ss}, {"nn", &Stress::nn},
                                         {"xs", &Stress::xs}, {"xn", &Stress::xn}, {"sn", &Stress::sn}};
/// Those that are a traction where the depth is 0.
constexpr NamedComponent tractions[] = {{"nn", &Stress::nn}, {"xn", &Stress::xn}, {"sn", &Stress::sn}};

/// MPa. Less is no traction of the surface.
constexpr double no_traction = 1e-9;

bool is_rising(std::span<const double> values) {
  return !values.empty() && std::ranges::all_of(values, [](double v) { return std::isfinite(v); }) &&
         std::ranges::adjacent_find(values, std::greater_equal()) == values.end();
}

[[noreturn]] void refuse(const std::string& file, const std::string& why, const std::string& what_to_do) {
  throw InputError(fmt::format("The table '{}' is no initial stress", file), why, what_to_do);
}

/// Which column is which; s may be missing.
struct Columns {
  std::optional<std::size_t> s;
  std::size_t depth = 0;
  std::vector<std::pair<std::size_t, double Stress::*>> stresses;

  Columns(const std::string& file, const std::vector<std::string>& names) {
    const auto place_of = [&](std::string_view name) -> std::optional<std::size_t> {
      const auto found = std::ranges::find(names, name);
      return found == names.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - names.begin()));
    };
    s = place_of("s");
    for (const auto& [name, value] : components)
      if (const auto at = place_of(name))
        stresses.emplace_back(*at, value);
    const auto found = place_of("depth");
    if (!found || stresses.empty() || names.size() != stresses.size() + (s ? 2 : 1))
      refuse(file, fmt::format("its columns are {}", fmt::join(names, ", ")),
             "Begin it with depth,xx or s,depth,xx,ss,nn,xs,xn,sn; a stress that is left out is 0.");
    depth = *found;
  }
};

} // namespace

InitialStress::InitialStress(std::vector<double> s, std::vector<double> depths, std::vector<Stress> values,
                             std::string name)
    : s_(std::move(s)), depths_(std::move(depths)), values_(std::move(values)), name_(std::move(name)) {
  if (!is_rising(s_) || !is_rising(depths_) || depths_.front() < 0 ||
      values_.size() != s_.size() * depths_.size())
    refuse(name_, "arc lengths and depths do not rise, or a value is missing",
           "Give each arc length the same depths, of 0 or more.");
  for (std::size_t i = 0; i < values_.size(); i += depths_.size())
    for (const auto& [component, value] : tractions)
      if (depths_.front() == 0 && std::abs(values_[i].*value) > no_traction)
        refuse(name_,
               fmt::format("{} is {:g} MPa at a depth of 0, where nothing presses on the surface", component,
                           values_[i].*value),
               "Begin it at 0 there.");
}

Stress InitialStress::at(double s, double depth) const {
  const PlaceInTable across(s_, s), down(depths_, depth);
  Stress out;
  for (const auto& [i, weight_s] :
       {std::pair{across.line, 1 - across.share}, std::pair{across.line + 1, across.share}})
    for (const auto& [j, weight_depth] :
         {std::pair{down.line, 1 - down.share}, std::pair{down.line + 1, down.share}})
      if (weight_s > 0 && weight_depth > 0)
        out.add(weight_s * weight_depth, values_[i * depths_.size() + j]);
  return out;
}

InitialStress read_initial_stress(const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::vector<std::string> names = csv_columns(file);
  const Columns columns(name, names);
  std::map<double, std::map<double, Stress>> table;
  for (const std::vector<double>& row : read_csv(file, names)) {
    Stress stress;
    for (const auto& [at, value] : columns.stresses)
      stress.*value = row[at];
    const double s = columns.s ? row[*columns.s] : 0, depth = row[columns.depth];
    if (!table[s].emplace(depth, stress).second)
      refuse(name, fmt::format("s = {:g} mm, depth = {:g} mm stands there twice", s, depth),
             "Keep one line.");
  }
  if (table.empty())
    refuse(name, "it has no numbers", "Give it a line for each depth.");
  std::vector<double> s, depths;
  std::vector<Stress> values;
  for (const auto& [depth, stress] : table.begin()->second)
    depths.push_back(depth);
  for (const auto& [at, column] : table) {
    s.push_back(at);
    if (!std::ranges::equal(column, depths, {}, [](const auto& line) { return line.first; }))
      refuse(name, fmt::format("s = {:g} mm has other depths than s = {:g} mm", at, s.front()),
             "Give each arc length the same depths.");
    for (const auto& [depth, stress] : column)
      values.push_back(stress);
  }
  return InitialStress(std::move(s), std::move(depths), std::move(values), name);
}

} // namespace bem_contact::shakedown
