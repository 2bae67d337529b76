#include "bem_contact/base/number_text.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <string>

namespace bem_contact {

/// The locale must be C's, which a page never leaves.
std::optional<double> number_of_text(std::string_view text) {
  constexpr std::string_view before_numbers = " \t\r\n\v\f+";
  if (text.empty() || before_numbers.find(text.front()) != text.npos || text.find_first_of("xX") != text.npos)
    return std::nullopt; // strtod() skips the former, and reads hexadecimal digits
  const std::string copy(text);
  char* end = nullptr;
  errno = 0;
  const double value = std::strtod(copy.c_str(), &end);
  const bool too_large_or_small = errno == ERANGE && (std::isinf(value) || value == 0);
  return end == copy.c_str() + copy.size() && !too_large_or_small ? std::optional(value) : std::nullopt;
}

} // namespace bem_contact
