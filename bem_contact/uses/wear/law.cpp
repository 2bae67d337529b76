#include "bem_contact/uses/wear/law.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact::wear {

namespace {

constexpr double kilograms = 1e-9;  // of a microgram
constexpr double millimetres = 1e3; // of a metre

void require(bool holds, std::string_view name, std::string_view why) {
  if (!holds)
    throw InputError(fmt::format("The wear law cannot have this {}", name), why, "Correct it.");
}

bool not_negative(double value) {
  return std::isfinite(value) && value >= 0;
}
bool positive(double value) {
  return std::isfinite(value) && value > 0;
}

std::size_t region(const std::vector<double>& borders, double value) {
  return static_cast<std::size_t>(std::ranges::lower_bound(borders, value) - borders.begin());
}

bool rising(const std::vector<double>& borders) {
  return std::ranges::all_of(borders, positive) &&
         std::ranges::adjacent_find(borders, std::greater_equal<>()) == borders.end();
}

void validate_one(const EnergyLaw& law) {
  for (const double value : {law.mild, law.severe, law.catastrophic})
    require(not_negative(value), "coefficient", "coefficients are finite and not negative");
  require(positive(law.mild_until) && std::isfinite(law.severe_until) && law.severe_until >= law.mild_until,
          "limit of a regime", "mild wear ends above 0, and severe wear does not end before mild wear");
  require(positive(law.density), "density", "it must be positive");
}

void validate_one(const ArchardLaw& law) {
  require(positive(law.hardness), "hardness", "it must be positive");
  require(positive(law.rolling_speed), "rolling speed", "it must be positive");
  const WearMap& map = law.map;
  require(rising(map.speeds), "border of sliding speed", "borders must be positive and rise");
  require(rising(map.pressures), "border of pressure", "borders must be positive and rise");
  const std::size_t regions = (map.speeds.size() + 1) * (map.pressures.size() + 1);
  require(map.coefficients.size() == regions, "map",
          fmt::format("{} borders of speed and {} of pressure make {} regions, and it has {} coefficients",
                      map.speeds.size(), map.pressures.size(), regions, map.coefficients.size()));
  require(std::ranges::all_of(map.coefficients, not_negative), "coefficient",
          "coefficients are finite and not negative");
}

double rate(const EnergyLaw& law, const Rubbing& rubbing) {
  return mass_rate(law, rubbing.power) * kilograms / millimetres / law.density;
}

double rate(const ArchardLaw& law, const Rubbing& rubbing) {
  const double k = coefficient(law.map, law.rolling_speed * rubbing.sliding, rubbing.pressure);
  return k * rubbing.pressure * rubbing.sliding / law.hardness;
}

} // namespace

Law law_named(std::string_view name, double hardness, double rolling_speed,
              const std::optional<WearMap>& map) {
  if (name == law_names[0] && map)
    throw InputError("There is a wear map, and the law does not use it",
                     fmt::format("a map belongs to the law '{}', asked for is '{}'", law_names[1], name),
                     fmt::format("Ask for {}, or leave out the map.", law_names[1]));
  if (name == law_names[0])
    return EnergyLaw{};
  if (name == law_names[1])
    return ArchardLaw{
        .hardness = hardness, .rolling_speed = rolling_speed, .map = map.value_or(kth_map(hardness))};
  throw InputError(fmt::format("There is no wear law '{}'", name),
                   fmt::format("known are {}", fmt::join(law_names, " and ")), "Use one of these.");
}

WearMap kth_map(double hardness) {
  return {.speeds = {200, 700},
          .pressures = {0.8 * hardness},
          .coefficients = {5.5e-4, 35e-4, 5.5e-4, 350e-4, 350e-4, 350e-4}};
}

double coefficient(const WearMap& map, double sliding_speed, double pressure) {
  return map.coefficients[region(map.pressures, pressure) * (map.speeds.size() + 1) +
                          region(map.speeds, sliding_speed)];
}

double mass_rate(const EnergyLaw& law, double power) {
  if (power <= law.mild_until)
    return law.mild * power;
  if (power <= law.severe_until)
    return law.severe;
  return law.severe + law.catastrophic * (power - law.severe_until);
}

double depth_rate(const Law& law, const Rubbing& rubbing) {
  return std::visit([&](const auto& one) { return rate(one, rubbing); }, law);
}

void validate(const Law& law) {
  std::visit([](const auto& one) { validate_one(one); }, law);
}

} // namespace bem_contact::wear
