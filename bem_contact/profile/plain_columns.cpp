#include "bem_contact/profile/profile_formats.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/text_lines.hpp"

#include <fmt/format.h>

namespace bem_contact {

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
    if (values.size() != 2)
      throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                       "a profile in plain columns has two numbers a line, y and z, with decimal points",
                       "Correct the line, or mark it as a comment with #.");
    require_finite(values, source, number);
    out.points.push_back({values[0], values[1]});
  }
  return out;
}

} // namespace bem_contact
