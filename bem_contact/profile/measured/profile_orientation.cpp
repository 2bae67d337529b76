#include "bem_contact/profile/measured/profile_orientation.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/measured/settings.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/wheel_datum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bem_contact {

namespace {

void flip_z(std::vector<Point2>& points) {
  for (Point2& p : points)
    p.z = -p.z;
}

void flip_z_by_shape(std::vector<Point2>& points, const std::string& source) {
  messages()->warn(
      "{}: z points up: its sign is changed, as the shape suggests (profile_z = \"up\" says so; \"down\" "
      "keeps it)",
      source);
  flip_z(points);
}

void mirror(MeasuredPoints& measured) {
  for (Point2& p : measured.points)
    p.y = -p.y;
  measured.y_sign = -measured.y_sign;
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
    flip_z_by_shape(points, source);
}

/// The top of a rail is broad. What is narrow at the top of something as wide as a wheel is a flange.
void require_rail(const std::vector<Point2>& points, const std::string& source) {
  const double top = std::ranges::min_element(points, {}, &Point2::z)->z;
  std::vector<Point2> high;
  std::ranges::copy_if(points, std::back_inserter(high), [&](Point2 p) { return p.z < top + top_depth; });
  const auto width = [&](const std::vector<Point2>& of) {
    const auto [low, last] = std::ranges::minmax(of, {}, &Point2::y);
    return last.y - low.y;
  };
  if (width(high) < narrowest_top && width(points) > widest_rail_head)
    throw InputError(
        fmt::format("{} is no profile of a rail", source),
        fmt::format("only {:.3g} of its {:.3g} mm are within {:g} mm of its top, as on the flange of a "
                    "wheel",
                    width(high), width(points), top_depth),
        "Give the rail's profile here and the wheel's as wheel.profile.");
}

/// A wheel's flange is what stands out most from the median height; it points down.
void mend_wheel_z(std::vector<Point2>& points, const std::string& source) {
  std::vector<double> heights;
  std::ranges::transform(points, std::back_inserter(heights), &Point2::z);
  const auto [top, bottom] = std::ranges::minmax(heights);
  const double middle = median(heights), down = bottom - middle, up = middle - top;
  if (up > down && up >= least_flange)
    flip_z_by_shape(points, source);
}

/// The flange lies at y < 0.
void mend_wheel_y(MeasuredPoints& measured, const std::string& source, const ProfileReading& reading) {
  const auto tip = flange_tip(measured.points);
  if (!tip)
    return;
  const auto [low, high] = std::ranges::minmax(measured.points, {}, &Point2::y);
  if (tip->y <= (low.y + high.y) / 2)
    return;
  if (reading.mirror)
    throw InputError(
        fmt::format("{}: mirror = true puts the flange on the field side", source),
        fmt::format("its tip would be at y = {:.4g} mm, and y points away from the track", tip->y),
        "Leave mirror out.");
  if (measured.axes_stated) {
    messages()->warn(
        "{}: the flange lies at y > 0, on the field side, as the format states its axes: it is not turned "
        "(mirror = true turns it)",
        source);
    return;
  }
  messages()->warn("{}: the flange lies at y > 0: y is mirrored (mirror = true says so)", source);
  mirror(measured);
}

/// A format that states its axes is not turned by the shape; a flange that points up is worth a word.
void look_at_stated_wheel(std::vector<Point2> points, const std::string& source) {
  if (flange_tip(points))
    return;
  flip_z(points);
  if (flange_tip(points))
    messages()->warn(
        "{}: the flange points up, as the format states its axes: it is not turned (profile_z = \"up\" "
        "turns it)",
        source);
}

} // namespace

void orient(MeasuredPoints& measured, const std::string& source, ProfileKind kind,
            const ProfileReading& reading) {
  const bool rail = kind == ProfileKind::rail;
  std::vector<Point2>& points = measured.points;
  if (reading.mirror)
    mirror(measured);
  if (reading.profile_z == ProfileZ::up)
    flip_z(points);
  // The signs are judged on a walk towards +y.
  if (points.front().y > points.back().y)
    std::reverse(points.begin(), points.end());
  if (reading.profile_z == ProfileZ::as_stated && !measured.axes_stated)
    rail ? mend_rail_signs(points, source) : mend_wheel_z(points, source);
  if (rail && !measured.axes_stated && reading.profile_z == ProfileZ::as_stated)
    require_rail(points, source);
  if (!rail && measured.axes_stated)
    look_at_stated_wheel(points, source);
  if (!rail)
    mend_wheel_y(measured, source, reading);
  if ((points.front().y < points.back().y) != rail)
    std::reverse(points.begin(), points.end());
}

} // namespace bem_contact
