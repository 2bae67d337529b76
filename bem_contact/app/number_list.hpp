#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

namespace bem_contact::app {

/// Numbers with one character between them, as "0:0.005:21" and "6,4,82000". Nothing for any other text, nan
/// and inf included.
inline std::optional<std::vector<double>> number_list(std::string_view text, char between) {
  std::vector<double> out;
  const char *at = text.data(), *end = at + text.size();
  for (double number = 0;; ++at) {
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc() || !std::isfinite(number) || (rest != end && *rest != between))
      return std::nullopt;
    out.push_back(number);
    if ((at = rest) == end)
      return out;
  }
}

/// The numbers of FROM:TO:COUNT, as "0:0.005:21". Nothing for any other text and for a count that is not
/// whole, or not from 2 to `most`.
inline std::optional<std::vector<double>> equal_steps(std::string_view text, int most) {
  const std::vector<double> numbers = number_list(text, ':').value_or(std::vector<double>());
  const double count = numbers.size() == 3 ? numbers[2] : 0;
  if (!(count >= 2 && count <= most && count == std::floor(count)))
    return std::nullopt;
  std::vector<double> out;
  for (int i = 0; i < count; ++i)
    out.push_back(numbers[0] + (numbers[1] - numbers[0]) * i / (count - 1));
  return out;
}

} // namespace bem_contact::app
