#include "bem_contact/profile/profile_orientation.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/settings.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bem_contact {

namespace {

void flip_z(std::vector<Point2>& points, const std::string& source) {
  spdlog::warn("{}: z points up: its sign is changed", source);
  for (Point2& p : points)
    p.z = -p.z;
}

/// A rail's head bulges upward from the chord between its ends.
void mend_rail_signs(std::vector<Point2>& points, const std::string& source) {
  const Point2 first = points.front(), chord = points.back() - first;
  const Point2 downward = normal_of(std::atan2(chord.z, chord.y));
  double bulge = 0;
  for (const Point2 p : points)
    if (const double height = dot(p - first, downward); std::abs(height) > std::abs(bulge))
      bulge = height;
  if (bulge > least_bulge * norm(chord))
    flip_z(points, source);
}

/// The top of a rail is broad. What is narrow at the top of something as wide as a wheel is a flange.
void require_rail(const std::vector<Point2>& points, const std::string& source) {
  const auto by_y = [](Point2 a, Point2 b) { return a.y < b.y; };
  const double top = std::ranges::min_element(points, {}, &Point2::z)->z;
  std::vector<Point2> high;
  std::ranges::copy_if(points, std::back_inserter(high), [&](Point2 p) { return p.z < top + top_depth; });
  const auto width = [&](const std::vector<Point2>& of) {
    const auto [low, last] = std::minmax_element(of.begin(), of.end(), by_y);
    return last->y - low->y;
  };
  if (width(high) < narrowest_top && width(points) > widest_rail_head)
    throw InputError(
        fmt::format("{} is no profile of a rail", source),
        fmt::format("only {:.3g} of its {:.3g} mm are within {:g} mm of its top, as on the flange of a "
                    "wheel",
                    width(high), width(points), top_depth),
        "Give the rail's profile here and the wheel's as wheel.profile.");
}

/// A wheel's flange is what stands out most from the median height; it points down and lies at y < 0.
void mend_wheel_signs(std::vector<Point2>& points, const std::string& source) {
  std::vector<Point2> by_height = points;
  std::sort(by_height.begin(), by_height.end(), [](Point2 a, Point2 b) { return a.z < b.z; });
  const double median = by_height[by_height.size() / 2].z;
  const double down = by_height.back().z - median, up = median - by_height.front().z;
  if (std::max(up, down) < least_flange)
    return;
  const Point2 tip = up > down ? by_height.front() : by_height.back();
  if (up > down)
    flip_z(points, source);
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](Point2 a, Point2 b) { return a.y < b.y; });
  if (tip.y > (low->y + high->y) / 2) {
    spdlog::warn("{}: the flange lies at y > 0: y is mirrored", source);
    for (Point2& p : points)
      p.y = -p.y;
  }
}

} // namespace

void orient(std::vector<Point2>& points, const std::string& source, ProfileKind kind) {
  const bool rail = kind == ProfileKind::rail;
  // The signs are judged on a walk towards +y.
  if (points.front().y > points.back().y)
    std::reverse(points.begin(), points.end());
  rail ? mend_rail_signs(points, source) : mend_wheel_signs(points, source);
  if (rail)
    require_rail(points, source);
  if ((points.front().y < points.back().y) != rail)
    std::reverse(points.begin(), points.end());
}

} // namespace bem_contact
