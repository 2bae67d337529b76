#include "bem_contact/profile/formats/profile_formats.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/formats/text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace bem_contact {

namespace {

struct Flags {
  const std::string& source;
  std::map<std::string, double> values = {};

  double get(const std::string& name, double otherwise) const {
    const auto found = values.find(name);
    return found == values.end() ? otherwise : found->second;
  }
  bool on(const std::string& name) const {
    const double value = get(name, 0);
    if (value != 0 && value != 1)
      throw InputError(fmt::format("{}: {} = {}", source, name, value), "it is a switch", "Give 0 or 1.");
    return value == 1;
  }
  double unit(const std::string& name, double otherwise) const {
    const double value = get(name, otherwise);
    if (!(value > 0))
      throw InputError(fmt::format("{}: {} = {}", source, name, value), "a unit factor is positive",
                       "Give the units per metre or per radian (1000 for mm, 1 for rad).");
    return value;
  }
};

void apply_bounds(std::vector<Point2>& points, const Flags& flags) {
  const auto outside = [&](const std::string& axis, double value) {
    const double low = flags.get("bound." + axis + ".min", 1), high = flags.get("bound." + axis + ".max", 0);
    return low < high && (value < low || value > high);
  };
  std::erase_if(points, [&](Point2 p) { return outside("y", p.y) || outside("z", p.z); });
}

void apply_flags(std::vector<Point2>& points, const Flags& flags) {
  if (const double smoothing = flags.get("approx.smooth", 0); smoothing != 0)
    throw InputError(fmt::format("{}: approx.smooth = {}", flags.source, smoothing),
                     "smoothing would change the profile in a way that only its own program defines",
                     "Export the smoothed points with approx.smooth = 0.");
  if (const double least = flags.get("point.dist.min", 0); least > 0) {
    std::vector<Point2> kept;
    for (const Point2 p : points)
      if (kept.empty() || norm(p - kept.back()) >= least)
        kept.push_back(p);
    points = std::move(kept);
  }
  const Point2 shift{flags.get("shift.y", 0), flags.get("shift.z", 0)};
  const double angle = flags.get("rotate", 0) / flags.unit("units.ang.f", 1);
  for (Point2& p : points) {
    p = p + shift;
    p = p.y * tangent_of(angle) + p.z * normal_of(angle);
  }
  apply_bounds(points, flags);
  const double to_mm = 1000 / flags.unit("units.len.f", 1000);
  const double sign_y = flags.on("mirror.y") ? -1 : 1, sign_z = flags.on("mirror.z") ? -1 : 1;
  for (Point2& p : points)
    p = {sign_y * to_mm * p.y, sign_z * to_mm * p.z};
  if (flags.on("inversion"))
    std::reverse(points.begin(), points.end());
}

} // namespace

bool is_simpack(std::string_view text) {
  return text.find("spline.begin") != std::string_view::npos ||
         text.find("point.begin") != std::string_view::npos;
}

MeasuredPoints simpack_points(std::string_view text, const std::string& source, ProfileKind kind) {
  enum class Block { none, header, spline, points, done } block = Block::none;
  Flags flags{source};
  std::vector<Point2> points;
  double type = -1;
  std::size_t number = 0;
  for (const std::string_view raw : lines_of(text)) {
    ++number;
    const std::string_view line = trimmed(raw.substr(0, raw.find_first_of("!%")));
    if (line.empty())
      continue;
    if (line == "header.begin") {
      block = Block::header;
    } else if (line == "header.end") {
      block = Block::none;
    } else if (line == "spline.begin") {
      block = Block::spline;
    } else if (line == "point.begin") {
      block = Block::points;
    } else if (line == "point.end") {
      block = Block::done;
    } else if (block == Block::points) {
      require_decimal_points(line, source, number);
      const std::vector<double> values = numbers_of(line);
      if (values.size() != 2 && values.size() != 3)
        throw InputError(fmt::format("{}:{}: '{}' is not a point", source, number, line.substr(0, 40)),
                         "between point.begin and point.end stand y, z and at most a weight",
                         "Correct the line.");
      require_finite(values, source, number);
      if (values.size() == 2 || values[2] > 0)
        points.push_back({values[0], values[1]});
    } else if (const auto equals = line.find('='); equals != std::string_view::npos) {
      const std::string key(trimmed(line.substr(0, equals)));
      const std::vector<double> values = numbers_of(line.substr(equals + 1));
      if (values.size() != 1)
        continue; // file, comment and other texts
      require_finite(values, source, number);
      if (block == Block::header && key == "type")
        type = values[0];
      if (block == Block::spline)
        flags.values[key] = values[0];
    }
  }
  if (block != Block::done)
    throw InputError(
        fmt::format("{} has no {}", source, block == Block::points ? "point.end" : "point.begin"),
        "the file is truncated", "Export it anew.");
  if (type >= 0 && type != (kind == ProfileKind::rail ? 0 : 1))
    throw InputError(fmt::format("{} is the profile of a {}", source, type == 0 ? "rail" : "wheel"),
                     fmt::format("its header says type = {}, a {} is asked for", type, name_of(kind)),
                     "Name the other file.");
  apply_flags(points, flags);
  return {std::move(points), 1, true};
}

} // namespace bem_contact
