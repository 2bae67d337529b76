#include "bem_contact/record/error_text.hpp"

#include "bem_contact/base/fixed_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::record {

namespace {

/// Digits of a value whose error is far below it. Without a limit, an error of 1e-14 would print as many
/// digits as a double has.
constexpr int most_digits = 10;

/// Digits before the decimal point; 0 and less where there are zeros after it. 1 of zero and of what is not
/// finite.
int digits_before(double value) {
  return value == 0 || !std::isfinite(value) ? 1
                                             : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
}

/// Decimals of two digits of an error, which may be negative.
int decimals_of(double error) {
  return 2 - digits_before(error);
}

} // namespace

std::string two_digits(double error) {
  if (!(error > 0))
    return "";
  const int decimals = std::clamp(decimals_of(error), 0, 9);
  return decimals < 7 ? fmt::format("{:.{}f}", error, decimals) : fmt::format("{:.1e}", error);
}

std::string fixed_fine(double value, double error, int decimals) {
  if (error > 0)
    decimals =
        std::clamp(decimals_of(error), decimals, std::max(decimals, most_digits - digits_before(value)));
  return fixed_text(value, std::max(decimals, 0));
}

std::string fixed_within(double value, double error, int decimals) {
  return fixed_fine(value, error, error > 0 ? std::min(decimals, decimals_of(error) + 1) : decimals);
}

std::string digits_fine(double value, double error, int digits) {
  const int decimals = digits - digits_before(value);
  if (error > std::abs(value)) // no digit of it is known: "0.00 +- 0.99"
    return fixed_text(value, std::clamp(decimals_of(error), 0, most_digits));
  return error > 0 || decimals < 0 ? fixed_fine(value, error, decimals)
                                   : fmt::format("{:.{}g}", value, digits);
}

std::string digits_within(double value, double error, int digits) {
  const int most = error > 0 ? decimals_of(error) + 1 + digits_before(value) : digits;
  return digits_fine(value, error, std::min(digits, most));
}

std::string rounded(double value, double error) {
  constexpr int digits_without_error = 4;
  if (!(error > 0) || !std::isfinite(error))
    return digits_fine(value, 0, digits_without_error);
  const int decimals = decimals_of(error);
  const auto to_two_digits = [decimals](double number) {
    const double unit = std::pow(10.0, -std::min(decimals, 0));
    return decimals > 0 ? number : unit * std::round(number / unit);
  };
  return fixed_text(to_two_digits(value), std::clamp(decimals, 0, most_digits)) +
         plus_minus(to_two_digits(error));
}

std::string plus_minus(double error) {
  const std::string text = two_digits(error);
  return text.empty() ? "" : " +- " + text;
}

} // namespace bem_contact::record
