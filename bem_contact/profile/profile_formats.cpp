#include "bem_contact/profile/profile_formats.hpp"

#include "bem_contact/base/error.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace bem_contact {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find_first_of("\r\n");
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos)
      break;
    const bool two = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    text.remove_prefix(end + (two ? 2 : 1));
  }
  return lines;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<double> numbers_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;";
  std::vector<double> values;
  for (;;) {
    const auto begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos)
      return values;
    line.remove_prefix(begin);
    std::string token(line.substr(0, line.find_first_of(separators)));
    line.remove_prefix(token.size());
    std::replace(token.begin(), token.end(), 'D', 'E'); // Fortran's exponent
    const char* first = token.c_str() + (token.front() == '+' ? 1 : 0);
    double value = 0;
    const auto [stop, problem] = std::from_chars(first, token.c_str() + token.size(), value);
    if (problem != std::errc{} || stop != token.c_str() + token.size())
      return {};
    values.push_back(value);
  }
}

void require_finite(const std::vector<double>& values, const std::string& source, std::size_t line) {
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    throw InputError(fmt::format("{}:{}: a coordinate is not a number", source, line),
                     "NaN and infinity are no places", "Remove or mend the point.");
}

std::vector<Point2> plain_points(std::string_view text, const std::string& source) {
  std::vector<Point2> points;
  bool names_seen = false;
  std::size_t number = 0;
  for (const std::string_view raw : lines_of(text)) {
    ++number;
    const std::string_view line = trimmed(raw);
    if (line.empty() || line.starts_with('#') || line.starts_with('!') || line.starts_with('%') ||
        line.starts_with("//"))
      continue;
    const std::vector<double> values = numbers_of(line);
    if (values.empty() && points.empty() && !names_seen) {
      names_seen = true;
      continue;
    }
    if (values.size() != 2)
      throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                       "a profile in plain columns has two numbers a line, y and z, with decimal points",
                       "Correct the line, or mark it as a comment with #.");
    require_finite(values, source, number);
    points.push_back({values[0], values[1]});
  }
  return points;
}

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
  std::size_t y_column = 0, z_column = 1, number = 0;
  double promised = -1;
  for (std::string_view line : lines_of(text)) {
    ++number;
    line = trimmed(line);
    if (line.starts_with('"')) // some programs leave a stray quote before a line
      line = trimmed(line.substr(1));
    if (line.ends_with('"'))
      line = trimmed(line.substr(0, line.size() - 1));
    if (line.empty() || line.starts_with('#'))
      continue;
    if (const auto equals = line.find('='); equals != std::string_view::npos) {
      const std::string_view key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
      const std::vector<double> values = numbers_of(value);
      if (key == "XYPoints" && values.size() == 1)
        promised = values[0];
      if (key == "ColumnDef") {
        std::size_t column = 0;
        for (std::size_t at = 0; at <= value.size(); ++column) {
          const auto end = std::min(value.find(',', at), value.size());
          const std::string_view name = trimmed(value.substr(at, end - at));
          if (name == "X" || name == "x")
            y_column = column;
          if (name == "Y" || name == "y")
            z_column = column;
          at = end + 1;
        }
      }
      if ((key == "XOffset" || key == "YOffset" || key == "Tilt") && values.size() == 1 && values[0] != 0)
        spdlog::warn("{}: {} = {} is not applied: the points are taken as they stand", source, key,
                     values[0]);
      continue;
    }
    const std::vector<double> values = numbers_of(line);
    if (values.empty() && points.empty())
      continue; // a title of the older variant
    if (values.size() <= std::max(y_column, z_column))
      throw InputError(
          fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
          fmt::format("y is expected in column {} and z in column {}", y_column + 1, z_column + 1),
          "Correct the line, or ColumnDef in the header.");
    require_finite(values, source, number);
    points.push_back({-values[y_column], values[z_column]});
  }
  if (promised >= 0 && static_cast<double>(points.size()) != promised)
    throw InputError(
        fmt::format("{} has {} points", source, points.size()),
        fmt::format("its header says XYPoints={}; the file is truncated or was altered", promised),
        "Export it anew, or correct XYPoints.");
  return points;
}

} // namespace bem_contact
