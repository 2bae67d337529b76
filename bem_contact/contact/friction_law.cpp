#include "bem_contact/contact/friction_law.hpp"

#include "bem_contact/base/place_in_table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace bem_contact {

double exponential_fall(double v) {
  return std::exp(-v);
}

double FallingFriction::factor(double slip_velocity) const {
  return ratio == 1 ? 1 : ratio + (1 - ratio) * fall(slip_velocity / scale);
}

FallingFriction exponential_friction(double mu_kin, double mu_1, double half) {
  return {mu_kin / (mu_kin + mu_1), half / std::numbers::ln2};
}

FallingFriction polach_friction(double a, double b) {
  constexpr double mm_per_m = 1000;
  return {a, mm_per_m / b};
}

double HotFriction::factor(double temperature) const {
  return 1 - (1 - ratio) * std::clamp((temperature - from) / (to - from), 0.0, 1.0);
}

double YieldLimit::at(double temperature) const {
  if (temperatures.empty())
    return shear;
  const PlaceInTable place(temperatures, temperature);
  const std::size_t next = std::min(place.line + 1, shears.size() - 1);
  return std::lerp(shears[place.line], shears[next], place.share);
}

bool YieldLimit::softens_by_heat() const {
  return least() < shear;
}

double YieldLimit::least() const {
  return shears.empty() ? shear : std::ranges::min(shears);
}

std::string yield_text(const YieldLimit& limit) {
  std::string out = fmt::format("yields at {:g} MPa", limit.shear);
  if (!limit.temperatures.empty())
    out += fmt::format(" ({:g} degrees C) to {:g} MPa ({:g})", limit.temperatures.front(),
                       limit.shears.back(), limit.temperatures.back());
  if (limit.hardening != 0)
    out += fmt::format(", and {} by {:g} MPa/mm", limit.hardening > 0 ? "hardens" : "softens",
                       std::abs(limit.hardening));
  return out;
}

LayerAnswer answer(const YieldLimit& limit, const LayerElement& element, double reach) {
  const auto& [before, friction, stiffness, weight] = element;
  const double now = limit.shear + limit.hardening * before, least = std::max(now, 0.0),
               slope = limit.hardening / weight;
  if (friction <= least) // it slips before it yields
    return {.bound = friction, .plastic = before};
  if (reach <= least)
    return {.bound = least, .plastic = before};
  // reach = bound + r |S|, and the bound rises by slope |S|.
  const double rise = now > 0 ? slope / (slope + stiffness) : 0, bound = least + rise * (reach - least);
  if (bound >= friction)
    return {.bound = friction, .plastic = (friction - limit.shear) / limit.hardening, .kept = 0};
  if (bound <= 0)
    return {.plastic = before + reach / (stiffness * weight), .yields = true, .kept = 0};
  return {.bound = bound,
          .plastic = before + (reach - bound) / (stiffness * weight),
          .yields = true,
          .rise = rise,
          .kept = 1 - rise};
}

double ThermalBody::effusivity() const {
  constexpr double megapascal = 1e-6; // J/(m^3 K) in MPa/K; W/(m K) is N/(s K)
  return std::sqrt(conductivity * density * heat_capacity * megapascal);
}

} // namespace bem_contact
