#include "bem_contact/profile/measured/profile_repair.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/measured/closed_outline.hpp"
#include "bem_contact/profile/measured/dense_scan.hpp"
#include "bem_contact/profile/measured/missing_values.hpp"
#include "bem_contact/profile/measured/profile_orientation.hpp"
#include "bem_contact/profile/measured/walk.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/settings.hpp"
#include "bem_contact/profile/wheel_datum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace bem_contact {

namespace {

/// 1 (share of the points). More may not be dropped as stray: then the file is another kind of wrong. Chosen.
constexpr double repairable_share = 0.05;
/// 1 (share of the length of the walk). An end point always shortens the walk when it is dropped; it is
/// dropped only if nothing else shortens the walk by nearly as much.
constexpr double end_point_penalty = 1e-3;
/// mm. A longer loop is shape, not noise. Chosen: about the distance of measured points.
constexpr double repairable_loop = 1.0;
/// mm. Widths that a rail's or wheel's profile can have. A wheel's rim is 140 mm wide.
constexpr double narrowest_profile = 10.0;
/// mm. A profile that is wider is none, either.
constexpr double widest_profile = 300.0;
/// mm. The same where the unit is said: somebody drew a wide circle, as in CONTACT's tests. In cm heads of
/// rails would be wider. Chosen.
constexpr double widest_in_said_unit = 500.0;
/// The file's unit. A profile this wide is in metres: no profile in mm is as narrow.
constexpr double narrowest_in_metres = 0.02;
/// The file's unit. A wider profile is not in metres.
constexpr double widest_in_metres = 0.3;
/// mm. A file whose unit is not said and that is narrower is asked about: heads of rails are wider than 60
/// mm, wheels wider than 100 mm, and in centimetres both are narrower than this.
constexpr double narrowest_unasked = 16.0;
/// mm. Widths that a whole rail or wheel has: what a narrower file would be in another unit.
constexpr double narrowest_guess = 55.0;
/// mm. A profile that is wider is none, either.
constexpr double widest_guess = 160.0;
/// 1. Points are out of order if sorting by y shortens the walk by this factor. Chosen: two shuffled points
/// of a short file already do.
constexpr double shuffled_walk = 1.5;
/// 1. A hole is so many times as long as the median chord,
constexpr double hole_length = 10.0;
/// mm. and at least so long;
constexpr double least_hole = 2.0;
/// deg. and the profile turns by more over it.
constexpr double hole_turn = 2.0;
/// deg. Two chords that turn by more, there and back, are a jump between two scans.
constexpr double jump_turn = 45.0;

double millimetres(ProfileUnit unit) {
  switch (unit) {
  case ProfileUnit::cm:
    return 10;
  case ProfileUnit::m:
    return 1000;
  case ProfileUnit::inch:
    return 25.4;
  default:
    return 1;
  }
}

/// What a width that no profile in mm has could be, and the keys that say so.
struct UnitGuess {
  std::string reason, keys;
};
UnitGuess guess_unit(double width) {
  struct Unit {
    const char *name, *key;
    ProfileUnit is;
  };
  UnitGuess out;
  for (const Unit& unit :
       {Unit{"centimetres", "cm", ProfileUnit::cm}, Unit{"inches", "inch", ProfileUnit::inch}}) {
    const double size = millimetres(unit.is) * width;
    if (size < narrowest_guess || size > widest_guess)
      continue;
    out.reason +=
        fmt::format("{}in {} it would be {:.4g} mm wide", out.reason.empty() ? "" : ", ", unit.name, size);
    out.keys += fmt::format("{}unit = \"{}\"", out.keys.empty() ? "" : " or ", unit.key);
  }
  return out;
}

void mend_units(std::vector<Point2>& points, const std::string& source, ProfileUnit unit) {
  const auto [low, high] = std::ranges::minmax(points, {}, &Point2::y);
  double width = high.y - low.y;
  const bool metres = unit == ProfileUnit::found && width >= narrowest_in_metres && width <= widest_in_metres;
  const double factor = metres ? 1000 : millimetres(unit);
  if (metres)
    say_warning("{}: {:.4g} wide: taken as metres", source, width);
  if (factor != 1)
    for (Point2& p : points)
      p = factor * p;
  width *= factor;
  const UnitGuess guess = unit == ProfileUnit::found ? guess_unit(width) : UnitGuess{};
  const double widest = unit == ProfileUnit::found ? widest_profile : widest_in_said_unit;
  if (!(width >= narrowest_profile && width <= widest) || (width < narrowest_unasked && !guess.keys.empty()))
    throw InputError(fmt::format("{}: the profile is {:.4g} mm wide", source, width),
                     guess.keys.empty()
                         ? "no rail or wheel is; the unit is neither mm nor m, or the columns are not y and z"
                         : fmt::format("hardly a rail or wheel is; {}", guess.reason),
                     guess.keys.empty() ? "Convert it to mm."
                                        : fmt::format("Convert it to mm, or say the unit: {}.", guess.keys));
}

const char* points_text(std::size_t count) {
  return count == 1 ? "point" : "points";
}

/// Drops points nearer than `crowded` to the one before; the last point stays.
void drop_crowded(std::vector<Point2>& points, const std::string& source) {
  std::vector<Point2> kept;
  for (const Point2 p : points)
    if (kept.empty() || norm(p - kept.back()) >= crowded)
      kept.push_back(p);
  if (norm(points.back() - kept.back()) > 0 && kept.size() > 1)
    kept.back() = points.back();
  if (const std::size_t dropped = points.size() - kept.size(); dropped > 0)
    say_info("{}: {} doubled or crowded {} dropped (nearer than {} mm)", source, dropped,
             points_text(dropped), crowded);
  points = std::move(kept);
}

/// Drops single stray points, each the one whose absence shortens the walk most.
bool drop_stray(std::vector<Point2>& points, const std::string& source) {
  std::vector<Point2> mended = points, stray;
  const auto most =
      static_cast<std::size_t>(std::max(1.0, repairable_share * static_cast<double>(points.size())));
  while (const auto at = first_zig_zag(mended)) {
    if (points.size() - mended.size() >= most || mended.size() <= 4)
      return false;
    std::size_t drop = *at;
    double shortest = path_length(mended);
    for (std::size_t i = *at - 1; i <= *at + 1; ++i) {
      std::vector<Point2> without = mended;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      // An end point always shortens the walk: it is dropped only where nothing else helps.
      const bool end = i == 0 || i + 1 == mended.size();
      if (const double length = path_length(without) + (end ? end_point_penalty * shortest : 0);
          length < shortest) {
        shortest = length;
        drop = i;
      }
    }
    stray.push_back(mended[drop]);
    mended.erase(mended.begin() + static_cast<std::ptrdiff_t>(drop));
  }
  std::string places;
  for (std::size_t i = 0; i < std::min(stray.size(), most_named_outliers); ++i)
    places += fmt::format("{}y = {:.4g}, z = {:.4g}", i > 0 ? "; " : "", stray[i].y, stray[i].z);
  say_warning("{}: {} {} dropped where the profile zig-zags, at {}{} mm of the file", source, stray.size(),
              points_text(stray.size()), places, stray.size() > most_named_outliers ? "; ..." : "");
  points = std::move(mended);
  return true;
}

void mend_order(std::vector<Point2>& points, const std::string& source) {
  const auto at = first_zig_zag(points);
  if (!at && !runs_back(points))
    return;
  std::vector<Point2> sorted = points;
  std::ranges::stable_sort(sorted, {}, &Point2::y);
  if (!first_zig_zag(sorted) && path_length(points) > shuffled_walk * path_length(sorted)) {
    say_warning("{}: the points are out of order: sorted by y", source);
    points = std::move(sorted);
    return;
  }
  if ((runs_back(points) || !drop_stray(points, source)) && !thin_scan(points, source)) {
    const Point2 where = at ? points[*at] : points[points.size() / 2];
    throw InputError(fmt::format("{}: the profile runs back and forth near y = {:.4g}, z = {:.4g}", source,
                                 where.y, where.z),
                     "its points are neither in walking order nor sortable by y",
                     "Order the points along the profile; of overlapping scans give one.");
  }
}

/// Where segments i and j > i + 1 cross, if they do.
std::optional<Point2> crossing(const std::vector<Point2>& p, std::size_t i, std::size_t j) {
  const Point2 a = p[i + 1] - p[i], b = p[j + 1] - p[j], c = p[j] - p[i];
  const double det = cross(a, b);
  if (det == 0)
    return std::nullopt;
  const double u = cross(c, b) / det, v = cross(c, a) / det;
  if (u < 0 || u > 1 || v < 0 || v > 1)
    return std::nullopt;
  return p[i] + u * a;
}

void mend_loops(std::vector<Point2>& points, const std::string& source) {
  for (std::size_t i = 0; i + 3 < points.size(); ++i)
    for (std::size_t j = i + 2; j + 1 < points.size(); ++j) {
      // Cheap test first: every pair of segments is looked at.
      if (std::min(points[j].y, points[j + 1].y) > std::max(points[i].y, points[i + 1].y) ||
          std::max(points[j].y, points[j + 1].y) < std::min(points[i].y, points[i + 1].y))
        continue;
      const auto where = crossing(points, i, j);
      if (!where)
        continue;
      const std::vector<Point2> loop(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      const double length = path_length(loop) + norm(loop.front() - *where) + norm(loop.back() - *where);
      if (length > repairable_loop)
        throw InputError(fmt::format("{}: the profile crosses itself at y = {:.4g}, z = {:.4g}", source,
                                     where->y, where->z),
                         fmt::format("the loop is {:.3g} mm long", length), "Remove the points of the loop.");
      say_warning("{}: a loop of {:.3g} mm cut off at y = {:.4g}, z = {:.4g}", source, length, where->y,
                  where->z);
      points.erase(points.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                   points.begin() + static_cast<std::ptrdiff_t>(j) + 1);
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(i) + 1, *where);
    }
}

/// Missing points and jumps are reported, not mended: the curve goes through the points that there are.
void report_holes(const std::vector<Point2>& p, const std::string& source) {
  std::vector<double> length;
  for (std::size_t i = 1; i < p.size(); ++i)
    length.push_back(norm(p[i] - p[i - 1]));
  const double usual = median(length);
  const auto direction = [&](std::size_t i) { return std::atan2(p[i + 1].z - p[i].z, p[i + 1].y - p[i].y); };
  const auto turn = [&](std::size_t from, std::size_t to) {
    return degrees(std::remainder(direction(to) - direction(from), 2 * std::numbers::pi));
  };
  std::size_t jumps = 0, first = 0;
  for (std::size_t i = 1; i + 2 < p.size(); ++i) {
    const double turned = std::abs(turn(i - 1, i + 1));
    if (length[i] > std::max(hole_length * usual, least_hole) && turned > hole_turn)
      say_warning(
          "{}: no points for {:.3g} mm from y = {:.4g} to y = {:.4g}, over which the profile turns by "
          "{:.2g} degrees: its shape there is a guess",
          source, length[i], p[i].y, p[i + 1].y, turned);
    const double into = turn(i - 1, i), out = turn(i, i + 1);
    if (into * out < 0 && std::min(std::abs(into), std::abs(out)) > jump_turn && ++jumps == 1)
      first = i;
  }
  if (jumps > 0)
    say_warning("{}: the profile jumps {} by {:.2g} mm at y = {:.4g}", source,
                jumps == 1 ? "once," : fmt::format("{} times, first", jumps), length[first], p[first].y);
}

} // namespace

std::vector<Point2> repaired(MeasuredPoints measured, const std::string& source, ProfileKind kind,
                             const ProfileReading& reading) {
  std::vector<Point2>& points = measured.points;
  const auto require_some = [&] {
    if (points.size() < 3)
      throw InputError(fmt::format("{} has {}", source, counted(points.size(), "point", "points")),
                       "a profile needs at least 3",
                       points.empty() ? "The file is empty or holds no numbers." : "Give more points.");
  };
  require_some();
  drop_missing_values(points, source);
  mend_units(points, source, reading.unit);
  drop_crowded(points, source);
  require_some();
  open_outline(points, source, kind);
  mend_order(points, source);
  drop_crowded(points, source); // sorting brings doubled points together
  require_some();
  orient(measured, source, kind, reading);
  if (kind == ProfileKind::wheel)
    set_wheel_datum(points, measured.y_sign, source, reading);
  mend_loops(points, source);
  report_holes(points, source);
  return std::move(points);
}

} // namespace bem_contact
