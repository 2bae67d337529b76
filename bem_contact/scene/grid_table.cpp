#include "bem_contact/scene/grid_table.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/scene/csv_table.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(); // not given yet

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why, const std::string& give) {
  throw InputError(fmt::format("The table '{}' does not fit the grid", file.string()), why, give);
}

} // namespace

std::vector<std::vector<double>> read_fields(const std::filesystem::path& file, const ContactGrid& grid,
                                             const std::vector<std::string>& names) {
  std::vector<std::string> columns{"ix", "is"};
  columns.insert(columns.end(), names.begin(), names.end());
  const std::string give =
      fmt::format("Give each of ix = 0 .. {}, is = 0 .. {} once.", grid.mx - 1, grid.ms - 1);
  std::vector<std::vector<double>> fields(names.size(), std::vector<double>(grid.size(), nan));
  for (const std::vector<double>& row : read_csv(file, columns)) {
    const bool whole = row[0] == std::floor(row[0]) && row[1] == std::floor(row[1]);
    const bool inside = row[0] >= 0 && row[0] < grid.mx && row[1] >= 0 && row[1] < grid.ms;
    const std::size_t at = whole && inside ? static_cast<std::size_t>(row[1] * grid.mx + row[0]) : 0;
    if (!whole || !inside || !std::isnan(fields[0][at]))
      refuse(file,
             fmt::format("element ({}, {}) is {}", row[0], row[1],
                         whole && inside ? "given twice" : "not one of it"),
             give);
    for (std::size_t k = 0; k < names.size(); ++k)
      fields[k][at] = row[2 + k];
  }
  for (int i = 0; i < grid.size(); ++i)
    if (std::isnan(fields[0][i]))
      refuse(file, fmt::format("element ({}, {}) is missing", i % grid.mx, i / grid.mx), give);
  return fields;
}

std::vector<double> read_row_values(const std::filesystem::path& file, const ContactGrid& grid,
                                    const std::string& name) {
  const std::string give = fmt::format("Give each of is = 0 .. {} once.", grid.ms - 1);
  std::vector<double> values(grid.ms, nan);
  for (const std::vector<double>& row : read_csv(file, {"is", name})) {
    if (row[0] != std::floor(row[0]) || row[0] < 0 || row[0] >= grid.ms)
      refuse(file, fmt::format("row {} is not one of it", row[0]), give);
    values[static_cast<std::size_t>(row[0])] = row[1];
  }
  for (int i = 0; i < grid.ms; ++i)
    if (std::isnan(values[i]))
      refuse(file, fmt::format("row {} is missing", i), give);
  return values;
}

} // namespace bem_contact
