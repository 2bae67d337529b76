#include "bem_contact/profile/miniprof_format.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/text_lines.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <optional>

namespace bem_contact {

namespace {

/// What the header says.
struct Header {
  std::size_t y_column = 0, z_column = 1;
  std::optional<double> points; ///< promised
};

/// "ColumnDef=X,Y,N,..": MiniProf calls y X and z Y.
void read_columns(std::string_view names, Header& header) {
  std::size_t column = 0;
  for (std::size_t at = 0; at <= names.size(); ++column) {
    const auto end = std::min(names.find(',', at), names.size());
    const std::string_view name = trimmed(names.substr(at, end - at));
    if (name == "X" || name == "x")
      header.y_column = column;
    if (name == "Y" || name == "y")
      header.z_column = column;
    at = end + 1;
  }
}

void read_key(std::string_view key, std::string_view value, const std::string& source, Header& header) {
  const std::vector<double> values = numbers_of(value);
  if (key == "XYPoints" && values.size() == 1)
    header.points = values[0];
  if (key == "ColumnDef")
    read_columns(value, header);
  if ((key == "XOffset" || key == "YOffset" || key == "Tilt") && values.size() == 1 && values[0] != 0)
    spdlog::warn("{}: {} = {} is not applied: the points are taken as they stand", source, key, values[0]);
}

/// Some programs leave stray quotes around a line.
std::string_view without_quotes(std::string_view line) {
  line = trimmed(line);
  if (line.starts_with('"'))
    line = trimmed(line.substr(1));
  if (line.ends_with('"'))
    line = trimmed(line.substr(0, line.size() - 1));
  return line;
}

} // namespace

bool is_miniprof(std::string_view text) {
  for (std::string_view line : lines_of(text)) {
    line = trimmed(line);
    if (line.starts_with("#MINIWHEELPROF") || line.starts_with("#MINIPROF") ||
        line.starts_with("XYPoints=") || line.starts_with("ColumnDef=") || line.starts_with("MPTypeNo=") ||
        line.starts_with("\"#MINI"))
      return true;
  }
  return false;
}

std::vector<Point2> miniprof_points(std::string_view text, const std::string& source) {
  std::vector<Point2> points;
  Header header;
  std::size_t number = 0;
  for (const std::string_view raw : lines_of(text)) {
    ++number;
    const std::string_view line = without_quotes(raw);
    if (line.empty() || line.starts_with('#'))
      continue;
    if (const auto equals = line.find('='); equals != std::string_view::npos) {
      read_key(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), source, header);
      continue;
    }
    const std::vector<double> values = numbers_of(line);
    if (values.empty() && points.empty())
      continue; // a title of the older variant
    if (values.size() <= std::max(header.y_column, header.z_column))
      throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                       fmt::format("y is expected in column {} and z in column {}", header.y_column + 1,
                                   header.z_column + 1),
                       "Correct the line, or ColumnDef in the header.");
    require_finite(values, source, number);
    points.push_back({-values[header.y_column], values[header.z_column]});
  }
  if (header.points >= 0 && static_cast<double>(points.size()) != *header.points)
    throw InputError(
        fmt::format("{} has {} points", source, points.size()),
        fmt::format("its header says XYPoints={}; the file is truncated or was altered", *header.points),
        "Export it anew, or correct XYPoints.");
  return points;
}

} // namespace bem_contact
