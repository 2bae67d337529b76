#pragma once

#include <cmath>
#include <fmt/format.h>
#include <string>

namespace bem_contact {

/// A number with so many decimals, as "{:.2f}" prints it, but never "-0.00".
inline std::string fixed_text(double value, int decimals) {
  const double smallest = 0.5 * std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", std::abs(value) < smallest ? 0.0 : value, decimals);
}

} // namespace bem_contact
