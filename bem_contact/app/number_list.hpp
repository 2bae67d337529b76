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

} // namespace bem_contact::app
