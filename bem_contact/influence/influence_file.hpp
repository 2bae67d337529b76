#pragma once

#include "bem_contact/influence/influence_function.hpp"

#include <filesystem>

namespace bem_contact {

inline constexpr int influence_format_major = 1;
inline constexpr int influence_format_minor = 0; ///< of a kernel
inline constexpr int table_format_minor = 1;     ///< of a table

/// Reads and checks an influence file (data/INFLUENCE_FORMAT.md). Throws InputError for a missing file, a
/// file that is not HDF5 or truncated, another major version, a checksum that does not hold, or contents
/// that validate() refuses.
InfluenceFunction read_influence_file(const std::filesystem::path& file);

/// Writes under a temporary name beside `file` and renames when complete: `file` is whole or absent.
void write_influence_file(const std::filesystem::path& file, const InfluenceFunction& function);

} // namespace bem_contact
