#include "bem_contact/profile/formats/profile_formats.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <fmt/format.h>

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
    const bool more = values.size() > 2 && line.find(',') == line.npos; // decimal commas make two of one
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

} // namespace

MeasuredPoints points_of(std::string_view text, const std::string& source, ProfileKind kind, int part,
                         bool left) {
  if (is_miniprof(text))
    return miniprof_points(text, source, part);
  if (part > 1)
    throw InputError(fmt::format("{} has no profile {}", source, part), "its format holds one",
                     "Leave out the number behind #.");
  return is_simpack(text)   ? simpack_points(text, source, kind)
         : is_vampire(text) ? vampire_points(text, source, kind, left)
                            : plain_points(text, source);
}

} // namespace bem_contact
