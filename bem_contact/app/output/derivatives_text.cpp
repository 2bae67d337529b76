#include "bem_contact/app/output/derivatives_text.hpp"

#include "bem_contact/sequence/derivative_record.hpp"
#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace bem_contact::app {

namespace {

/// Those that fit on a line.
constexpr std::array<std::string_view, 6> shown{"Fx", "Fy", "Fz", "approach", "pmax", "T_gamma"};

std::string reach_text(double step) {
  return std::isfinite(step) ? fmt::format("{:.1e}", step) : "any";
}

double total_of(const InputDerivatives& input, std::string_view name) {
  for (std::size_t k = 0; k < derived_totals().size(); ++k)
    if (derived_totals()[k] == name)
      return input.totals[k];
  return std::nan("");
}

/// Where a profile is worth most.
std::string profile_text(const ProfileDerivatives& profile) {
  std::string out = fmt::format("derivatives by {} points of {} along their normals, where they are largest:",
                                profile.points.size(), profile.name);
  for (const std::string_view name : shown) {
    const auto at = [&](const InputDerivatives& point) { return std::abs(total_of(point, name)); };
    const auto largest = std::ranges::max_element(profile.by_point, {}, at);
    if (name != "Fz" && at(*largest) > 0)
      out += fmt::format("\n{:>24} {:>12.5g} {} at s = {:.2f} mm", name, total_of(*largest, name),
                         unit_per(quantity(name).unit.of(false), "mm"),
                         profile.points[std::size_t(largest - profile.by_point.begin())].s);
  }
  return out + "\n";
}

std::string numbers_text(const SceneResult& r) {
  if (r.derivatives.empty())
    return "";
  std::string out = fmt::format("derivatives, on these elements with their states:\n{:>24}", "by");
  for (const std::string_view name : shown)
    out += fmt::format(" {:>12}", fmt::format("{} {}", name, quantity(name).unit.of(false)));
  out += "  holds for\n";
  for (const InputDerivatives& input : r.derivatives) {
    out +=
        fmt::format("{:>24}", input.unit == "1" ? input.name : fmt::format("{} {}", input.name, input.unit));
    for (const std::string_view name : shown)
      out += fmt::format(" {:>12.5g}", total_of(input, name));
    out += fmt::format("  -{} +{}\n", reach_text(input.below), reach_text(input.above));
  }
  return out;
}

} // namespace

std::string derivatives_text(const SceneResult& r) {
  std::string out = numbers_text(r);
  for (const ProfileDerivatives& profile : r.profile_derivatives)
    out += profile_text(profile);
  return out;
}

} // namespace bem_contact::app
