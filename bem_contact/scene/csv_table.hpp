#pragma once

#include "bem_contact/contact/problem.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace bem_contact {

struct CsvCell {
  std::string text; ///< trimmed if it has no quotes
  bool quoted = false;
};
struct CsvLine {
  int number = 0; ///< in the file, from 1
  std::vector<CsvCell> cells;
};

/// The lines of a CSV file (RFC 4180, but no line break within quotes) that are not empty. '#' outside quotes
/// starts a comment. Throws InputError for a file that cannot be read, and for semicolons between its names.
std::vector<CsvLine> csv_lines(const std::filesystem::path& file);

/// Throws InputError that names file and line.
[[noreturn]] void refuse_line(const std::filesystem::path& file, const CsvLine& line, const std::string& why,
                              const std::string& what_to_do);

/// Throws InputError unless the line has one cell for each column. It names the likely cause: semicolons
/// between the cells, or decimal commas.
void require_cells(const std::filesystem::path& file, const CsvLine& line, std::size_t columns);

/// The names in the first line of a table of numbers. Throws InputError for a file that cannot be read or is
/// empty.
std::vector<std::string> csv_columns(const std::filesystem::path& file);

/// Reads a CSV file whose first line names exactly `columns`. Rows of finite numbers.
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
