#include "bem_contact/profile/formats/profile_formats.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

namespace bem_contact {

namespace {

std::string first_word(std::string_view line) {
  line = trimmed(line);
  std::string word(line.substr(0, line.find_first_of(" \t=")));
  std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::toupper(c); });
  return word;
}

std::optional<ProfileKind> kind_of(std::string_view text) {
  const auto lines = lines_of(text);
  const std::string word = lines.empty() ? "" : first_word(lines.front());
  if (word == "WHEELPROFILE")
    return ProfileKind::wheel;
  if (word == "RAILPROFILE")
    return ProfileKind::rail;
  return std::nullopt;
}

} // namespace

bool is_vampire(std::string_view text) {
  return kind_of(text).has_value();
}

MeasuredPoints vampire_points(std::string_view text, const std::string& source, ProfileKind kind,
                              const ProfileReading& reading) {
  const bool left = reading.mirror;
  if (kind_of(text) != kind)
    throw InputError(fmt::format("{} is no profile of a {}", source, name_of(kind)),
                     "its first line says the other", "Name the other file.");
  MeasuredPoints out;
  out.axes_stated = kind == ProfileKind::rail;
  out.y_sign = left ? -1 : 1;
  std::optional<double> back_to_back;
  const auto lines = lines_of(text);
  for (std::size_t i = 2; i < lines.size(); ++i) { // the second line is a title
    const std::string_view line = without_comment(lines[i]);
    if (first_word(line) == "FLANGEBACK") {
      const auto values = numbers_of(line.substr(line.find_first_of(" \t=") + 1));
      if (values.size() == 1)
        back_to_back = values[0];
    }
    if (line.empty() || first_word(line) == "FLANGEBACK" || first_word(line) == "TREADDATUM" ||
        first_word(line) == "GAUGEPOINT" || first_word(line) == "GAUGE")
      continue;
    require_decimal_points(line, source, i + 1);
    const std::vector<double> values = numbers_of(line);
    if (values.size() != 4)
      throw InputError(fmt::format("{}:{}: '{}' is not a pair of points", source, i + 1, line.substr(0, 40)),
                       "a line has y and z of the left and y and z of the right profile",
                       "Correct the line.");
    require_finite(values, source, i + 1);
    out.points.push_back(left ? Point2{-values[0], values[1]} : Point2{values[2], values[3]});
  }
  if (out.points.empty())
    return out;
  double zero = 0;
  if (kind == ProfileKind::wheel) {
    if (!back_to_back)
      throw InputError(fmt::format("{} has no FLANGEBACK", source), "it says where the wheel's y = 0 is",
                       "Add the distance between the flange backs, in mm.");
    zero = *back_to_back / 2 + reading.tape_circle;
  } else {
    const auto [low, high] = std::ranges::minmax(out.points, {}, &Point2::y);
    zero = (low.y + high.y) / 2;
  }
  for (Point2& p : out.points)
    p = {p.y - zero, kind == ProfileKind::rail ? -p.z : p.z};
  return out;
}

} // namespace bem_contact
