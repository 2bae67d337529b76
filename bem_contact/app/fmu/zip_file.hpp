#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact::app {

/// A file in an archive.
struct ZipEntry {
  std::string name;  ///< with folders, by '/'
  std::string bytes; ///< what it holds
};

/// Writes a zip archive, which is whole or absent (base/output_file.hpp). The same entries give the same
/// bytes. Throws InputError for a name that cannot be written to, Error where writing fails.
void write_zip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries);

} // namespace bem_contact::app
