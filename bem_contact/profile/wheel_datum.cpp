#include "bem_contact/profile/wheel_datum.hpp"

#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

/// mm. How far the tip of a flange lies from its back: 15 mm on S1002 (EN 13715), 12 to 22 on worn and
/// American wheels.
constexpr double nearest_tip_to_back = 5.0;
/// mm. As above.
constexpr double farthest_tip_from_back = 32.0;
/// mm. Range of the tip's y over wheels whose y = 0 is at the tape circle: 62 to 78 mm from the back.
constexpr double lowest_tip = -75.0;
/// mm. As above.
constexpr double highest_tip = -35.0;
/// mm. y of the tip of S1002.
constexpr double usual_tip = -55.0;
/// mm. A file whose flange ends in a steep face elsewhere than at its usual place by more has another datum,
/// or another distance of the tape circle from the back: 58 to 65 mm on trams, 77.8 in America.
constexpr double usual_back = 3.0;
/// mm. So wide is what belongs to that face: draft, and noise.
constexpr double back_face = 0.5;
/// 1. Slope from there to the face's end: 1 mm of S1002 beside its back rises by 7.
constexpr double least_back_slope = 2.5;
/// mm. A worn wheel may be as low at its tape circle; more is another datum.
constexpr double highest_tape_circle = 6.0;

/// Height at y = 0, by the chord that spans it on the walk's first crossing from the field side.
std::optional<double> height_at_tape_circle(std::span<const Point2> p) {
  for (std::size_t i = 1; i < p.size(); ++i)
    if (p[i - 1].y >= 0 && p[i].y < 0)
      return p[i].z + (p[i - 1].z - p[i].z) * p[i].y / (p[i].y - p[i - 1].y);
  return std::nullopt;
}

void warn_of_height(std::span<const Point2> points, const std::string& source) {
  const auto height = height_at_tape_circle(points);
  if (height && std::abs(*height) > highest_tape_circle)
    say_warning(
        "{}: at the tape circle z is {:.3g} mm: the wheel's radius there is position.wheel_radius and "
        "that much more",
        source, *height);
}

/// y of the back of the flange, where the file goes as far: it ends there in a steep face behind the tip.
std::optional<double> steep_back(std::span<const Point2> points, Point2 tip) {
  const Point2 end = *std::ranges::min_element(points, {}, &Point2::y);
  if (tip.y - end.y < nearest_tip_to_back)
    return std::nullopt;
  // How far the face rises above the next point inwards.
  std::optional<Point2> inner;
  double top = end.z;
  for (const Point2 p : points) {
    if (p.y <= end.y + back_face)
      top = std::min(top, p.z);
    else if (p.y < tip.y && (!inner || p.y < inner->y))
      inner = p;
  }
  const bool steep = inner && inner->z - top > least_back_slope * (inner->y - end.y);
  return steep ? std::optional(end.y) : std::nullopt;
}

void warn_of_back(std::span<const Point2> points, double y_sign, const std::string& source,
                  double tape_circle) {
  const auto tip = flange_tip(points);
  const auto back = tip ? steep_back(points, *tip) : std::nullopt;
  if (!back || std::abs(*back + tape_circle) <= usual_back)
    return;
  say_warning(
      "{}: the flange ends in a steep face at y = {:.1f} mm of the file, and where y = 0 is at the tape "
      "circle its back is at {:g} mm: is this the back? (wheel.flange_back = {:.1f} puts it at its place; "
      "{:g} says that y is as it should be)",
      source, y_sign * *back, -y_sign * tape_circle, y_sign * *back, -y_sign * tape_circle);
}

} // namespace

std::optional<Point2> flange_tip(std::span<const Point2> points) {
  if (points.size() < 3)
    return std::nullopt;
  const Point2 tip = *std::ranges::max_element(points, {}, &Point2::z);
  std::vector<double> heights;
  std::ranges::transform(points, std::back_inserter(heights), &Point2::z);
  const auto [low, high] = std::ranges::minmax(points, {}, &Point2::y);
  const bool near_end = std::abs(tip.y - (low.y + high.y) / 2) > (high.y - low.y) / 4;
  if (!near_end || tip.z - median(std::move(heights)) < least_flange)
    return std::nullopt;
  return tip;
}

void set_wheel_datum(std::vector<Point2>& points, double y_sign, const std::string& source,
                     const ProfileReading& reading) {
  if (reading.keep_origin)
    return;
  const auto move = [&](double back) {
    for (Point2& p : points)
      p.y -= back + reading.tape_circle;
  };
  const auto tip = flange_tip(points);
  if (reading.flange_back) {
    move(y_sign * *reading.flange_back);
  } else if (tip && tip->y >= nearest_tip_to_back && tip->y <= farthest_tip_from_back) {
    say_warning(
        "{}: the tip of the flange is at y = {:.1f} mm, so y = 0 is taken as the back of the flange, not "
        "as the tape circle (wheel.flange_back = 0 says so; another value says otherwise)",
        source, y_sign * tip->y);
    move(0);
  } else if (tip && (tip->y < lowest_tip || tip->y > highest_tip)) {
    say_warning(
        "{}: the tip of the flange is at y = {:.1f} mm, where neither the tape circle nor the back of the "
        "flange is at y = 0: the wheel stands {:.0f} mm beside its place (say wheel.flange_back)",
        source, y_sign * tip->y, std::abs(tip->y - usual_tip));
  } else {
    warn_of_back(points, y_sign, source, reading.tape_circle);
  }
  warn_of_height(points, source);
}

} // namespace bem_contact
