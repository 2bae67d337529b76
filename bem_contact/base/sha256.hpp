#pragma once

#include <cstddef>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace bem_contact {

/// Characters of a SHA-256, which is given in lower-case hexadecimal.
inline constexpr std::size_t sha256_size = 64;

/// SHA-256 of the pieces after each other.
std::string sha256(std::initializer_list<std::span<const std::byte>> pieces);
/// Returns the SHA-256 of one text.
std::string sha256(std::string_view text);
/// Returns the SHA-256 of all that follows in the stream.
std::string sha256_of_rest(std::istream& in);
/// Returns the SHA-256 of a file of any size. Throws InputError where it cannot be read.
std::string sha256_of_file(const std::string& file);

} // namespace bem_contact
