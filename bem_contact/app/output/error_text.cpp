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

namespace {

/// Decimals of one digit more than two_digits(), which may be negative.
int decimals_within(double error) {
  return 2 - static_cast<int>(std::floor(std::log10(error)));
}

} // namespace

std::string fixed_within(double value, double error, int decimals) {
  if (error > 0)
    decimals = std::clamp(decimals_within(error), 0, decimals);
  const double unit = std::pow(10.0, -decimals);
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * unit ? 0.0 : value, decimals);
}

std::string digits_within(double value, double error, int digits) {
  if (error > 0 && value != 0) {
    const int before = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    digits = std::clamp(before + decimals_within(error), 1, digits);
  }
  return fmt::format("{:.{}g}", value, digits);
}

std::string counted(int count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
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
