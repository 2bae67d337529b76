#include "bem_contact/app/output/derivatives_text.hpp"

#include "bem_contact/sequence/quantities.hpp"

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

} // namespace

std::string derivatives_text(const SceneResult& r) {
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

} // namespace bem_contact::app
