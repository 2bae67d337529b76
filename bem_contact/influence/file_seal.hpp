#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace bem_contact {

/// The seal of an influence file: its first 512 bytes (HDF5's "user block", which HDF5 programs skip). Text,
/// then zeros:
///     conformal-contact influence function\n
///     format <major>.<minor>\n
///     bytes <of the whole file>\n
///     sha256 <of everything after the seal>\n
///     xxh3 <of these four lines and of everything after the seal>\n
/// Whoever reads the file checks the last line, and the fourth where there is no fifth: SHA-256 of a file of
/// 30 MB is a thousand million instructions without help by the processor.
/// The HDF5 library is given only files whose seal holds, so that no damaged file reaches it.
inline constexpr std::size_t seal_size = 512;

/// Writes the seal over the first 512 bytes of a complete file in memory.
void seal(std::span<std::byte> whole_file, int format_major, int format_minor);

/// The seal of a file that begins as one does, damaged or not; "" of any other, and where it cannot be read.
/// Whole files of one seal are the same, and no damaged one is ever solved with. So this tells files of
/// hundreds of megabytes apart without reading them.
std::string seal_of(const std::filesystem::path& file);
inline bool begins_with_seal(const std::filesystem::path& file) {
  return !seal_of(file).empty();
}

/// Throws InputError for an output that is there and no influence file: somebody else's. An empty file may be
/// replaced.
void require_replaceable_influence(const std::filesystem::path& file);

/// The SHA-256 in a seal that holds, as hexadecimal text. Throws InputError for a file that is
/// missing, no influence file, of another major version, truncated or altered.
std::string check_seal(const std::filesystem::path& file, int format_major);

} // namespace bem_contact
