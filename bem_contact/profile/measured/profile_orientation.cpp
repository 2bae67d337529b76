#include "bem_contact/profile/measured/profile_orientation.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/wheel_datum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace bem_contact {

namespace {

/// 1 (share of the chord between the ends). A rail's head that bulges down by more has its z upside down.
/// Chosen: a rail's head bulges by more than a tenth of its width.
constexpr double least_bulge = 0.005;
/// 1. A profile that bulges to the other side of that chord by more than this share has no side that is up: a
/// head beside a groove has a half. Chosen; worn heads stay below a twentieth.
constexpr double both_bulges = 0.2;
/// mm. The middle of a rail that is measured from the centre of the track lies between these, for gauges from
/// 600 to 1676 mm.
constexpr double nearest_rail_to_centre = 250.0;
/// mm. As above.
constexpr double farthest_rail_from_centre = 950.0;
/// rad. The flank of a flange is as steep as 60 to 78 degrees, chamfers are 45, and faces of rims vertical.
constexpr double flattest_flank = 50 * std::numbers::pi / 180;
/// rad. As above.
constexpr double steepest_flank = 82 * std::numbers::pi / 180;
/// mm. Something wider than a rail's head whose top is narrower than this, so far below its highest point, is
/// a wheel with its flange up. The head of 60E1 is 72 mm wide, and 56 mm at this depth.
constexpr double top_depth = 3.0;
/// mm. As above.
constexpr double narrowest_top = 25.0;
/// mm. As above.
constexpr double widest_rail_head = 90.0;

void flip_z(std::vector<Point2>& points) {
  for (Point2& p : points)
    p.z = -p.z;
}

void flip_z_by_shape(std::vector<Point2>& points, const std::string& source) {
  say_warning(
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

[[noreturn]] void ask_for_z(const std::string& source, const std::string& shape) {
  throw InputError(fmt::format("{}: z may point up or down", source),
                   fmt::format("nothing in the file says it, and {}", shape),
                   "Say where z of the file points: profile_z = \"up\" or profile_z = \"down\".");
}

/// A rail's head bulges upward from the chord between its ends. With a groove or a gap it bulges both ways.
void mend_rail_signs(std::vector<Point2>& points, const std::string& source) {
  const Point2 first = points.front(), chord = points.back() - first;
  const Point2 downward = normal_of(std::atan2(chord.z, chord.y));
  double down = 0, up = 0;
  for (const Point2 p : points) {
    down = std::max(down, dot(p - first, downward));
    up = std::max(up, -dot(p - first, downward));
  }
  if (std::min(down, up) > both_bulges * std::max(down, up) && std::max(down, up) > least_bulge * norm(chord))
    ask_for_z(source, "the profile bulges to both sides, as heads with a groove or a gap do either way up");
  if (down > up && down > least_bulge * norm(chord))
    flip_z_by_shape(points, source);
}

/// A rail that is measured from the centre of the track says by its y on which side it lies: its gauge side
/// is the nearer one to y = 0, and belongs at the smaller y.
void mend_rail_side(MeasuredPoints& measured, const std::string& source) {
  const auto [low, high] = std::ranges::minmax(measured.points, {}, &Point2::y);
  const double middle = std::midpoint(low.y, high.y);
  if (-middle < nearest_rail_to_centre || -middle > farthest_rail_from_centre)
    return;
  const std::string place =
      fmt::format("{}: y = {:.4g} .. {:.4g} mm counts from the centre of the track", source, low.y, high.y);
  if (measured.axes_stated) {
    say_warning("{}, and its gauge side is at the larger y, where the format states the field side: it is "
                "not turned (mirror = true turns it)",
                place);
    return;
  }
  say_warning("{}, which tells its gauge side: y is mirrored (mirror = true says so)", place);
  mirror(measured);
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

/// What the shape of a wheel says of its z.
enum class WheelZ { down, up, either, no_flange };

/// Signed heights of a wheel's points, and where they are greatest.
struct Relief {
  std::vector<double> height; ///< above the median, mm; in the direction that is looked at
  std::size_t top = 0;

  Relief(const std::vector<Point2>& points, double sign) {
    std::ranges::transform(points, std::back_inserter(height), [&](Point2 p) { return sign * p.z; });
    const double middle = median(height);
    for (double& h : height)
      h -= middle;
    top = static_cast<std::size_t>(std::ranges::max_element(height) - height.begin());
  }
  double greatest() const { return height[top]; }
  /// How far the walk comes down again on that side of the top where it comes down less: 0 at an end.
  double fall() const {
    const auto at = height.begin() + static_cast<std::ptrdiff_t>(top);
    return greatest() -
           std::max(*std::min_element(height.begin(), at + 1), *std::min_element(at, height.end()));
  }
};

/// The tip of a flange: the walk comes down from it on either side, and it is nearer to an end than to the
/// middle.
bool has_tip(const std::vector<Point2>& points, const Relief& relief) {
  const auto [low, high] = std::ranges::minmax(points, {}, &Point2::y);
  const double off = std::abs(points[relief.top].y - std::midpoint(low.y, high.y));
  return relief.fall() >= least_flange && off > (high.y - low.y) / 4;
}

/// How steep the steepest part is of what leads to the top, rad; parts of a quarter of its height each.
double steepness(const std::vector<Point2>& points, const Relief& relief) {
  const bool forward = relief.top < points.size() / 2; // to the longer side
  std::size_t i = relief.top;
  Point2 above = points[i];
  double steepest = 0;
  for (const double share : {0.75, 0.5, 0.25}) {
    while (relief.height[i] > share * relief.greatest() && (forward ? i + 1 < points.size() : i > 0))
      forward ? ++i : --i;
    const Point2 down = points[i] - above;
    steepest = std::max(steepest, std::atan2(std::abs(down.z), std::abs(down.y)));
    above = points[i];
  }
  return steepest;
}

/// A whole flange tells by its tip. Where the file ends before the tip, the flank of a flange is steep but
/// not vertical; what is vertical may be the back or the front of the rim, which lead the other way, and what
/// is less steep a chamfer.
WheelZ wheel_z(const std::vector<Point2>& points) {
  const Relief down(points, 1), up(points, -1);
  if (const bool tip = has_tip(points, down); tip != has_tip(points, up))
    return tip ? WheelZ::down : WheelZ::up;
  else if (tip)
    return WheelZ::either;
  const auto steep = [&](const Relief& relief) {
    return relief.greatest() < least_flange ? 0 : steepness(points, relief);
  };
  const double to_down = steep(down), to_up = steep(up);
  const auto flank = [](double angle) { return angle > flattest_flank && angle < steepest_flank; };
  if (const bool is = flank(to_down); is != flank(to_up))
    return is ? WheelZ::down : WheelZ::up;
  // A tread, or the groove of a roller, stays as it stands. Other shapes would have been turned, or are
  // faces.
  const bool gentle = std::max(to_down, to_up) < flattest_flank;
  return gentle && (up.greatest() < least_flange || up.greatest() < down.greatest()) ? WheelZ::no_flange
                                                                                     : WheelZ::either;
}

void mend_wheel_z(std::vector<Point2>& points, const std::string& source) {
  switch (wheel_z(points)) {
  case WheelZ::down:
    return;
  case WheelZ::up:
    return flip_z_by_shape(points, source);
  case WheelZ::either:
    ask_for_z(source, "its shape has no whole flange that would tell");
  case WheelZ::no_flange:
    say_warning("{}: nothing says where z points, neither the file nor a flange: it is taken to point down "
                "(profile_z = \"down\" says so; \"up\" turns it)",
                source);
  }
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
    say_warning(
        "{}: the flange lies at y > 0, on the field side, as the format states its axes: it is not turned "
        "(mirror = true turns it)",
        source);
    return;
  }
  say_warning("{}: the flange lies at y > 0: y is mirrored (mirror = true says so)", source);
  mirror(measured);
}

/// A format that states its axes is not turned by the shape; a flange that points up is worth a word.
void look_at_stated_wheel(const std::vector<Point2>& points, const std::string& source) {
  if (wheel_z(points) == WheelZ::up)
    say_warning(
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
  else if (rail && !reading.keep_origin)
    mend_rail_side(measured, source);
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
