#include "bem_contact/base/number_text.hpp"

#include <charconv>

namespace bem_contact {

std::optional<double> number_of_text(std::string_view text) {
  double value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  return problem == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

} // namespace bem_contact
