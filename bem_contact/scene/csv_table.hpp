#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact {

/// The names in the first line of a CSV file. Throws InputError for a file that cannot be read or is empty.
std::vector<std::string> csv_columns(const std::filesystem::path& file);

/// Reads a CSV file whose first line names exactly `columns`; '#' starts a comment. Rows of finite numbers.
/// Throws InputError for a missing file, another header, or a line that does not fit.
std::vector<std::vector<double>> read_csv(const std::filesystem::path& file,
                                          const std::vector<std::string>& columns);

} // namespace bem_contact
