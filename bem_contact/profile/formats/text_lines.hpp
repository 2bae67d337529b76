#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Lines and numbers of a text file, for the readers of the profile formats.
namespace bem_contact {

std::vector<std::string_view> lines_of(std::string_view text);
std::string_view trimmed(std::string_view text);

/// The line without what follows !, %, # or a quotation mark, trimmed; a quotation mark that begins it is
/// skipped.
std::string_view without_comment(std::string_view line);

/// The number that `word` is, whatever the locale, with an optional sign; nothing if it is none.
std::optional<double> parse_number(std::string_view word);

/// The numbers of a line, separated by blanks, commas or semicolons; empty if any word is not a number.
/// "nan" and "inf" are numbers here, so that require_finite() can refuse them by name.
std::vector<double> numbers_of(std::string_view line);

/// "-0,5": one comma, between two digits, and no point.
bool has_decimal_comma(std::string_view word);

/// Throws InputError that names the line if it writes numbers with decimal commas ("0,5 1,5"): a comma
/// separates numbers here, so that such a line would be read as twice as many.
void require_decimal_points(std::string_view line, const std::string& source, std::size_t number);

/// Throws InputError that names the line.
void require_finite(const std::vector<double>& values, const std::string& source, std::size_t line);

} // namespace bem_contact
