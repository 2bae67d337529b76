#include "bem_contact/profile/formats/text_lines.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace bem_contact {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos)
      break;
    const bool two = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (two ? 2 : 1));
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string_view without_comment(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('"'))
    line.remove_prefix(1);
  return trimmed(line.substr(0, line.find_first_of("!%#\"")));
}

std::optional<double> parse_number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-"))
    word.remove_prefix(1);
  return number_of_text(word);
}

std::vector<double> numbers_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;";
  std::vector<double> values;
  for (;;) {
    const auto begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos)
      return values;
    line.remove_prefix(begin);
    std::string token(line.substr(0, line.find_first_of(separators)));
    line.remove_prefix(token.size());
    std::replace(token.begin(), token.end(), 'D', 'E'); // Fortran's exponent
    const std::optional<double> value = parse_number(token);
    if (!value)
      return {};
    values.push_back(*value);
  }
}

bool has_decimal_comma(std::string_view word) {
  const auto digit = [&](std::size_t i) { return i < word.size() && word[i] >= '0' && word[i] <= '9'; };
  const auto comma = word.find(',');
  return comma != word.npos && comma > 0 && digit(comma - 1) && digit(comma + 1) &&
         word.find(',', comma + 1) == word.npos && word.find('.') == word.npos;
}

void require_decimal_points(std::string_view line, const std::string& source, std::size_t number) {
  constexpr std::string_view between = " \t;";
  std::size_t words = 0, commas = 0;
  for (std::string_view rest = line;;) {
    const auto begin = rest.find_first_not_of(between);
    if (begin == rest.npos)
      break;
    rest.remove_prefix(begin);
    const std::string_view word = rest.substr(0, rest.find_first_of(between));
    rest.remove_prefix(word.size());
    ++words;
    commas += has_decimal_comma(word) ? 1 : 0;
  }
  if (words > 1 && commas > 0)
    throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                     "its numbers have decimal commas, and a comma separates numbers here",
                     "Write them with decimal points.");
}

void require_finite(const std::vector<double>& values, const std::string& source, std::size_t line) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw InputError(fmt::format("{}:{}: a coordinate is not a number", source, line),
                     "NaN and infinity are no places", "Remove or mend the point.");
}

} // namespace bem_contact
