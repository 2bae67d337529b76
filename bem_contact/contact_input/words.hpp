#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact::contact_input {

/// The words of one line. Blanks, tabs, commas and "=" stand between words; what follows "%" is a remark. A
/// text between single quotes is one word, and keeps its quotes.
std::vector<std::string> words_of(std::string_view line);

/// A number as Fortran's F edit descriptor reads it: "1.5d-3", ".3", "+2", and "0.1-07", which is 0.1e-07.
/// Nothing for what is none, and for what no double holds.
std::optional<double> fortran_real(std::string_view word);
/// An angle in rad: as a number; with the ending "d" in degrees, with "r" in rad.
std::optional<double> fortran_angle(std::string_view word);
/// A whole number; "1.0" is one, as Intel's Fortran reads it.
std::optional<long> fortran_integer(std::string_view word);
/// What stands between single quotes.
std::optional<std::string> quoted(std::string_view word);

} // namespace bem_contact::contact_input
