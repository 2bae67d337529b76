#include "bem_contact/profile/formats/profile_formats.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"
#include "bem_contact/profile/messages.hpp"

#include <fmt/format.h>

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
    say_warning("{}: {} = {} is not applied: the points are taken as they stand", source, key, values[0]);
}

/// One profile of a file.
struct Part {
  Header header;
  std::vector<Point2> points;
};

/// "#MINIWHEELPROF", "MINIPROF 101 148 ...": how the older variant begins, with a quotation mark or without.
bool begins_old_variant(std::string_view line) {
  line = trimmed(line);
  for (const char mark : {'"', '#'})
    if (line.starts_with(mark))
      line.remove_prefix(1);
  return line.starts_with("MINIPROF") || line.starts_with("MINIWHEELPROF") ||
         line.starts_with("MINIRAILPROF");
}

/// Whether points may begin only after an empty line: the header of the older variant has numbers of its own.
bool header_ends_at_empty_line(const std::vector<std::string_view>& lines) {
  return begins_old_variant(lines.front()) &&
         std::ranges::any_of(lines, [](std::string_view line) { return trimmed(line).empty(); });
}

Point2 point_of(std::string_view line, const Header& header, const std::string& source, std::size_t number) {
  require_decimal_points(line, source, number);
  const std::vector<double> values = numbers_of(line);
  if (values.size() <= std::max(header.y_column, header.z_column))
    throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                     fmt::format("y is expected in column {} and z in column {}", header.y_column + 1,
                                 header.z_column + 1),
                     "Correct the line, or ColumnDef in the header.");
  require_finite(values, source, number);
  return {-values[header.y_column], values[header.z_column]};
}

std::vector<Part> parts_of(std::string_view text, const std::string& source) {
  const std::vector<std::string_view> lines = lines_of(text);
  bool in_header = header_ends_at_empty_line(lines);
  std::vector<Part> parts(1);
  Header next;            ///< of the section that describes the next points
  bool described = false; ///< by keys that follow points: what comes next is another profile
  std::size_t number = 0;
  for (const std::string_view raw : lines) {
    ++number;
    if (in_header && trimmed(raw).empty())
      in_header = false;
    const std::string_view line = without_comment(raw);
    if (line.empty() || in_header)
      continue;
    if (line.starts_with('[')) {
      if (line.find("Points") != std::string_view::npos) {
        if (!parts.back().points.empty())
          parts.emplace_back();
        parts.back().header = next;
        described = false;
      } else {
        next = {};
      }
      continue;
    }
    if (const auto equals = line.find('='); equals != std::string_view::npos) {
      const bool begun = !parts.back().points.empty();
      Header& header = begun ? next : parts.back().header;
      described = begun;
      const std::string_view key = trimmed(line.substr(0, equals)), value = trimmed(line.substr(equals + 1));
      read_key(key, value, source, header);
      if (&header != &next)
        next = header;
      continue;
    }
    if (numbers_of(line).empty() && parts.back().points.empty())
      continue; // a title of the older variant
    if (described) {
      parts.emplace_back().header = next;
      described = false;
    }
    parts.back().points.push_back(point_of(line, parts.back().header, source, number));
  }
  return parts;
}

} // namespace

bool is_miniprof(std::string_view text) {
  const std::vector<std::string_view> lines = lines_of(text);
  if (!lines.empty() && begins_old_variant(lines.front()))
    return true;
  for (std::string_view line : lines) {
    line = trimmed(line);
    if (line.starts_with("#MINI") || line.starts_with("\"#MINI") || line.starts_with("XYPoints=") ||
        line.starts_with("ColumnDef=") || line.starts_with("MPTypeNo=") || line == "[FileInfo]" ||
        line == "[Profile1Info]" || line == "[Profile1Points]")
      return true;
  }
  return false;
}

MeasuredPoints miniprof_points(std::string_view text, const std::string& source, int part) {
  std::vector<Part> parts = parts_of(text, source);
  const int count = static_cast<int>(parts.size());
  if (part > count)
    throw InputError(fmt::format("{} has no profile {}", source, part), fmt::format("it holds {}", count),
                     "Give a number that is there.");
  if (part == 0 && count > 1)
    throw InputError(fmt::format("{} holds {} profiles", source, count), "one is needed",
                     "Say which behind the file's name: #1 for the first.");
  const Part& chosen = parts[static_cast<std::size_t>(std::max(part, 1) - 1)];
  if (chosen.header.points >= 0 && static_cast<double>(chosen.points.size()) != *chosen.header.points)
    throw InputError(fmt::format("{} has {}", source, counted(chosen.points.size(), "point", "points")),
                     fmt::format("its header says XYPoints={}; the file is truncated or was altered",
                                 *chosen.header.points),
                     "Export it anew, or correct XYPoints.");
  return {chosen.points, -1};
}

} // namespace bem_contact
