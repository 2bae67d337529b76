#pragma once

#include "bem_contact/contact/problem.hpp"

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

/// Reads a CSV file with the columns ix, is, then `names`: every element of the grid exactly once. One field
/// [ms][mx] for each name. Throws InputError for a file that cannot be used.
std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names);

/// Reads a CSV file with the columns is, `name`: every row exactly once; [ms].
std::vector<double> read_row_values(const std::filesystem::path& file, const ContactGrid& grid,
                                    const std::string& name);

} // namespace bem_contact
