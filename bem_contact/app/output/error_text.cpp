#include "bem_contact/app/output/error_text.hpp"

#include "bem_contact/sequence/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::app {

std::string two_digits(double error) {
  if (!(error > 0))
    return "";
  const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 9);
  return decimals < 7 ? fmt::format("{:.{}f}", error, decimals) : fmt::format("{:.1e}", error);
}

std::string plus_minus(double error) {
  const std::string text = two_digits(error);
  return text.empty() ? "" : " +- " + text;
}

std::string plus_minus(const SceneResult& result, const char* name) {
  const Quantity& number = quantity(name);
  return number.error ? plus_minus(number.error(result)) : "";
}

} // namespace bem_contact::app
