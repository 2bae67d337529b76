#pragma once

#include <cstdio>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>

namespace bem_contact {

/// A text without what a terminal takes for an order (escape sequences, a carriage return alone), and in
/// UTF-8: each such character becomes a question mark. Names of files and texts of result files may be
/// anybody's, and Python and JSON take nothing but UTF-8.
std::string printable(std::string_view text);

/// Writes printable(text). It does not throw where the stream is full or closed: checked_exit_code() says so
/// of standard output, and of standard error nobody could read it.
void print_printable(std::FILE* to, std::string_view text);

/// What a program prints for people, on standard output.
template <class... Values> void print_out(fmt::format_string<Values...> form, Values&&... values) {
  print_printable(stdout, fmt::format(form, std::forward<Values>(values)...));
}
/// The same on standard error.
template <class... Values> void print_error(fmt::format_string<Values...> form, Values&&... values) {
  print_printable(stderr, fmt::format(form, std::forward<Values>(values)...));
}

} // namespace bem_contact
