#include "bem_contact/base/printable.hpp"

#include <algorithm>
#include <cstdio>

namespace bem_contact {

namespace {

/// How many bytes the character at the front takes in UTF-8; 0 where there is none.
std::size_t character_length(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if (length == 0 || first > 0xf4 || text.size() < length)
    return 0;
  const auto is_rest = [](unsigned char c) { return (c & 0xc0) == 0x80; };
  if (!std::ranges::all_of(text.substr(1, length - 1), is_rest))
    return 0;
  const auto second = static_cast<unsigned char>(length > 1 ? text[1] : 0);
  const bool other = (first == 0xe0 && second < 0xa0) ||
                     (first == 0xed && second > 0x9f) || // half a character
                     (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f);
  return other ? 0 : length;
}

/// Whether a terminal takes the character at the front for an order: the control characters of ASCII but tab
/// and the ends of lines, and those of Latin 1 (U+0080 to U+009F).
bool is_control(std::string_view text) {
  const auto first = static_cast<unsigned char>(text.front());
  if (first == '\r')
    return !text.starts_with("\r\n");
  return (first < 0x20 && first != '\n' && first != '\t') || first == 0x7f ||
         (first == 0xc2 && text.size() > 1 && static_cast<unsigned char>(text[1]) < 0xa0);
}

bool is_plain(char c) {
  return static_cast<unsigned char>(c - 0x20) < 0x5f || c == '\n' || c == '\t';
}

} // namespace

std::string printable(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    if (const auto other = std::ranges::find_if_not(text, is_plain); other != text.begin()) {
      out.append(text.begin(), other);
      text.remove_prefix(static_cast<std::size_t>(other - text.begin()));
      continue;
    }
    const std::size_t length = character_length(text);
    length == 0 || is_control(text) ? out.append(1, '?') : out.append(text.substr(0, length));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

void print_printable(std::FILE* to, std::string_view text) {
  const std::string plain = printable(text);
  static_cast<void>(std::fwrite(plain.data(), 1, plain.size(), to)); // checked_exit_code() asks the stream
}

} // namespace bem_contact
