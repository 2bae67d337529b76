#include "bem_contact/profile/formats/profile_formats.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace bem_contact {

namespace {

/// The points of a text in two columns "y z". Comments begin with #, !, %, a quotation mark or (at the start
/// of a line) with //; one line of column names may come first. `source` names the file in messages. Throws
/// InputError for any other line.
MeasuredPoints plain_points(std::string_view text, const std::string& source) {
  MeasuredPoints out;
  bool names_seen = false;
  std::size_t number = 0;
  for (const std::string_view raw : lines_of(text)) {
    ++number;
    const std::string_view line = without_comment(raw);
    if (line.empty() || line.starts_with("//"))
      continue;
    const std::vector<double> values = numbers_of(line);
    if (values.empty() && out.points.empty() && !names_seen) {
      names_seen = true;
      continue;
    }
    require_decimal_points(line, source, number);
    const bool more = values.size() > 2;
    if (values.size() != 2)
      throw InputError(
          fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
          more ? fmt::format("it has {} columns, and a profile has two, y and z", values.size())
               : "a profile in plain columns has two numbers a line, y and z, with decimal points",
          more ? "Leave y and z alone in the file." : "Correct the line, or mark it as a comment with #.");
    require_finite(values, source, number);
    out.points.push_back({values[0], values[1]});
  }
  return out;
}

/// What a file is that is no text in columns, by how it begins; "": not known.
std::string_view other_kind_of_file(std::string_view text) {
  struct Mark {
    std::string_view begin, kind;
  };
  constexpr Mark marks[] = {{"PK\x03\x04", "a spreadsheet or a ZIP file"},
                            {"\xd0\xcf\x11\xe0", "a spreadsheet"},
                            {"%PDF", "a PDF file"},
                            {"\x1f\x8b", "a compressed file"},
                            {"\x89PNG", "a picture"},
                            {"<?xml", "XML"},
                            {"<!", "HTML"},
                            {"<html", "HTML"},
                            {"{", "JSON"}};
  const auto first = text.find_first_not_of(" \t\r\n");
  const std::string_view begins = text.substr(std::min(first, text.size()));
  for (const Mark& mark : marks)
    if (begins.starts_with(mark.begin))
      return mark.kind;
  const auto next = begins.starts_with('[') ? begins.find_first_not_of(" \t\r\n", 1) : begins.npos;
  return next != begins.npos &&
                 std::string_view("[{-+.0123456789").find(begins[next]) != std::string_view::npos
             ? "JSON"
             : "";
}

void require_text_in_columns(std::string_view text, const std::string& source) {
  const std::string_view kind = other_kind_of_file(text);
  if (kind.empty() && text.find('\0') == std::string_view::npos)
    return;
  throw InputError(fmt::format("{} is no table of points", source),
                   kind.empty() ? "it is no text: it has bytes that are 0 (perhaps UTF-16)"
                                : fmt::format("it begins like {}", kind),
                   "Write y and z of each point on a line of a text file, with decimal points.");
}

} // namespace

MeasuredPoints points_of(std::string_view text, const std::string& source, ProfileKind kind, int part,
                         const ProfileReading& reading) {
  if (is_miniprof(text))
    return miniprof_points(text, source, part);
  if (part > 1)
    throw InputError(fmt::format("{} has no profile {}", source, part), "its format holds one",
                     "Leave out the number behind #.");
  if (!is_simpack(text) && !is_vampire(text))
    require_text_in_columns(text, source);
  return is_simpack(text)   ? simpack_points(text, source, kind)
         : is_vampire(text) ? vampire_points(text, source, kind, reading)
                            : plain_points(text, source);
}

} // namespace bem_contact
