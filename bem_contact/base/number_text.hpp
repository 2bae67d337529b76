#pragma once

#include <optional>
#include <string_view>

namespace bem_contact {

/// The number that the whole text is, as std::from_chars() reads it in any locale: without blanks or a sign
/// "+"; "nan" and "inf" too. Nothing for any other text, or for a number that a double cannot hold. One of
/// two sources has it: number_text.cpp, or number_text_strtod.cpp for a standard library that lacks it for
/// doubles.
std::optional<double> number_of_text(std::string_view text);

} // namespace bem_contact
