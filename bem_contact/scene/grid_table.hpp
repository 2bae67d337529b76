#pragma once

#include "bem_contact/contact/problem.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact {

/// Reads a CSV file with the columns ix, is, then `names`: every element of the grid exactly once. One field
/// [ms][mx] for each name. Throws InputError for a file that cannot be used.
std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names);

/// Reads a CSV file with the columns is, `name`: every row exactly once; [ms].
std::vector<double> read_row_values(const std::filesystem::path& file, const ContactGrid& grid,
                                    const std::string& name);

} // namespace bem_contact
