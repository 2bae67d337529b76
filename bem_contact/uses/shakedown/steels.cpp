#include "bem_contact/uses/shakedown/steels.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace bem_contact::shakedown {

namespace {

/// 1. Reversed tension over R_m of steel, and torsion over reversed tension (FKM guideline, chapter 2.2).
constexpr double tension_factor = 0.45, torsion_factor = 0.577;
/// 1. Cycles at the knee of the Woehler line of shear stresses, and its exponent (FKM guideline,
/// chapter 2.4).
constexpr double knee_cycles = 1e6, exponent = 8;

constexpr std::array<Steel, 12> all{{{"R200", "EN 13674-1", 680},
                                     {"R220", "EN 13674-1", 770},
                                     {"R260", "EN 13674-1", 880},
                                     {"R260Mn", "EN 13674-1", 880},
                                     {"R320Cr", "EN 13674-1", 1080},
                                     {"R350HT", "EN 13674-1", 1175},
                                     {"R370CrHT", "EN 13674-1", 1280},
                                     {"R400HT", "EN 13674-1", 1280},
                                     {"ER6", "EN 13262", 780, 500},
                                     {"ER7", "EN 13262", 820, 520},
                                     {"ER8", "EN 13262", 860, 540},
                                     {"ER9", "EN 13262", 900, 580}}};

} // namespace

double Steel::torsion_limit() const {
  return torsion_factor * tension_factor * tensile_strength;
}
double Steel::dang_van_a() {
  return 3 * (torsion_factor - 0.5);
}
std::optional<double> Steel::yield_shear() const {
  return yield ? std::optional(*yield / std::numbers::sqrt3) : std::nullopt;
}

std::span<const Steel> steels() {
  return all;
}

const Steel& steel_of(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Steel::name);
  if (found != all.end())
    return *found;
  std::vector<std::string> names;
  for (const Steel& steel : all)
    names.emplace_back(steel.name);
  const auto like = nearest_names(std::string(name), names);
  throw InputError(fmt::format("unknown steel '{}'", name), "it is none of EN 13674-1 or EN 13262",
                   like.empty() ? fmt::format("Known are {}.", fmt::join(names, ", "))
                                : fmt::format("Did you mean {}?", fmt::join(like, " or ")));
}

double cycles_of(double shear_stress, double torsion_limit) {
  return shear_stress <= torsion_limit ? std::numeric_limits<double>::infinity()
                                       : knee_cycles * std::pow(shear_stress / torsion_limit, -exponent);
}

} // namespace bem_contact::shakedown
