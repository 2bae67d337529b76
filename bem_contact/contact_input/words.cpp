#include "bem_contact/contact_input/words.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace bem_contact::contact_input {

namespace {

bool separates(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0 || c == ',' || c == '=';
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Length of "+12.5", ".3" or "12." at the beginning; 0 without a digit.
std::size_t mantissa_length(std::string_view word) {
  std::size_t at = !word.empty() && (word[0] == '+' || word[0] == '-') ? 1 : 0, digits = 0;
  bool point = false;
  for (; at < word.size() && (is_digit(word[at]) || (word[at] == '.' && !point)); ++at)
    is_digit(word[at]) ? void(++digits) : void(point = true);
  return digits > 0 ? at : 0;
}

/// The exponent behind a mantissa, in the form "e-07": "d-07", "E-7", "q7" and "-07" are one. Nothing for
/// others.
std::optional<std::string> exponent_of(std::string_view rest) {
  if (rest.empty())
    return "";
  const bool letter = std::string_view("eEdDqQ").find(rest[0]) != std::string_view::npos;
  if (letter)
    rest.remove_prefix(1);
  const bool sign = !rest.empty() && (rest[0] == '+' || rest[0] == '-');
  if (!letter && !sign)
    return std::nullopt;
  const std::string_view digits = rest.substr(sign ? 1 : 0);
  if (digits.empty() || !std::ranges::all_of(digits, is_digit))
    return std::nullopt;
  return (sign && rest[0] == '-' ? "e-" : "e") + std::string(digits);
}

} // namespace

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t at = 0; at < line.size() && line[at] != '%';) {
    if (separates(line[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    if (line[at] == '\'') {
      const std::size_t close = line.find('\'', at + 1);
      at = close == std::string_view::npos ? line.size() : close + 1;
    }
    while (at < line.size() && !separates(line[at]) && line[at] != '%')
      ++at;
    out.emplace_back(line.substr(begin, at - begin));
  }
  return out;
}

std::optional<double> fortran_real(std::string_view word) {
  const std::size_t length = mantissa_length(word);
  const std::optional<std::string> exponent = exponent_of(word.substr(length));
  if (length == 0 || !exponent)
    return std::nullopt;
  const std::string text =
      std::string(word.substr(word[0] == '+' ? 1 : 0, length - (word[0] == '+' ? 1 : 0))) + *exponent;
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<double> fortran_angle(std::string_view word) {
  const char last =
      word.empty() ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(word.back())));
  const bool degrees = last == 'd';
  if (degrees || last == 'r')
    word.remove_suffix(1);
  const std::optional<double> value = fortran_real(word);
  return value && degrees ? std::optional(*value * (std::numbers::pi / 180)) : value;
}

std::optional<long> fortran_integer(std::string_view word) {
  constexpr double largest = 1e15;
  const std::optional<double> value = fortran_real(word);
  if (!value || *value != std::round(*value) || std::abs(*value) > largest ||
      word.find_first_of("eEdDqQ") != std::string_view::npos)
    return std::nullopt;
  return static_cast<long>(*value);
}

std::optional<std::string> quoted(std::string_view word) {
  if (word.size() < 2 || word.front() != '\'' || word.back() != '\'')
    return std::nullopt;
  return std::string(word.substr(1, word.size() - 2));
}

} // namespace bem_contact::contact_input
