#include "bem_contact/profile/measured/missing_values.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/profile/median.hpp"
#include "bem_contact/profile/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bem_contact {

namespace {

/// 1 (median distances from the median). A point farther away may mark a missing value: on a line the ends
/// are two such distances away, and where most points lie on the flange its tread ends at some twenty.
/// Chosen.
constexpr double farthest_point = 30.0;
/// 1 (median distances of neighbouring points). A mark of a missing value lies behind such a jump. Chosen.
constexpr double jump_to_mark = 10.0;
/// 1 (range of the other points). A number of nines that lies beyond them by less is a place: -99.9 may well
/// be where a keeper begins. Chosen.
constexpr double farthest_of_nines = 0.1;
/// 1. In fewer points there is no median to trust.
constexpr std::size_t least_points_with_marks = 8;

/// Median of one coordinate, and the median distance from it: up to half of the points may be marks.
struct Middle {
  double at = 0, spread = 0;
};
Middle middle_of(const std::vector<Point2>& points, double Point2::*coordinate) {
  std::vector<double> values;
  std::ranges::transform(points, std::back_inserter(values), coordinate);
  const double at = median(values);
  for (double& value : values)
    value = std::abs(value - at);
  return {at, median(std::move(values))};
}

/// 99, 999.99, -9999: a number of nines alone, at least two of them before the point.
bool of_nines(double value) {
  const std::string digits = fmt::format("{:.10g}", std::abs(value));
  return digits.starts_with("99") && digits.find_first_not_of("9.") == std::string::npos;
}

/// Where the points lie whose coordinate is no number of nines.
struct Range {
  double low = 0, high = 0;

  bool far_beyond(double value) const {
    return std::max(low - value, value - high) > farthest_of_nines * (high - low);
  }
};
Range range_of(const std::vector<Point2>& points, double Point2::*coordinate) {
  std::vector<double> values;
  for (const Point2& p : points)
    if (!of_nines(p.*coordinate))
      values.push_back(p.*coordinate);
  if (values.empty())
    return {};
  const auto [low, high] = std::ranges::minmax(values);
  return {low, high};
}

/// Finds runs of points that may be marks, and looks whether the walk jumps there and back.
class Marks {
public:
  explicit Marks(const std::vector<Point2>& points)
      : points_(points), y_(middle_of(points, &Point2::y)), z_(middle_of(points, &Point2::z)),
        of_y_(range_of(points, &Point2::y)), of_z_(range_of(points, &Point2::z)),
        far_(farthest_point * std::max(y_.spread, z_.spread)), jump_(jump_to_mark * median_spacing(points)) {}

  /// One for each point.
  std::vector<bool> found() const {
    std::vector<bool> out(points_.size(), false);
    for (std::size_t from = 0, to = 0; from < points_.size(); from = to + 1) {
      to = from;
      if (!may_be(points_[from]))
        continue;
      while (to + 1 < points_.size() && may_be(points_[to + 1]))
        ++to;
      for (std::size_t i = from; i <= to; ++i)
        out[i] = is_mark(i, from, to);
    }
    return out;
  }

private:
  bool is_far(Point2 p) const { return std::abs(p.y - y_.at) > far_ || std::abs(p.z - z_.at) > far_; }
  bool has_nines(Point2 p) const {
    return (of_nines(p.y) && of_y_.far_beyond(p.y)) || (of_nines(p.z) && of_z_.far_beyond(p.z));
  }
  bool may_be(Point2 p) const { return is_far(p) || has_nines(p) || (p.y == 0 && p.z == 0); }
  /// The point i of the run from .. to.
  bool is_mark(std::size_t i, std::size_t from, std::size_t to) const {
    const Point2* before = from > 0 ? &points_[from - 1] : nullptr;
    const Point2* after = to + 1 < points_.size() ? &points_[to + 1] : nullptr;
    const auto stays = [&](const Point2* other) { return other && norm(points_[i] - *other) <= jump_; };
    if (stays(before) || stays(after) || (!before && !after))
      return false;
    if (is_far(points_[i]) || has_nines(points_[i]))
      return true;
    // (0, 0) may well lie on a profile of few points.
    return before && after &&
           norm(points_[i] - *before) + norm(points_[i] - *after) > 2 * norm(*after - *before);
  }

  const std::vector<Point2>& points_;
  Middle y_, z_;
  Range of_y_, of_z_;
  double far_, jump_;
};

} // namespace

void drop_missing_values(std::vector<Point2>& points, const std::string& source) {
  if (points.size() < least_points_with_marks)
    return;
  const std::vector<bool> missing = Marks(points).found();
  std::vector<Point2> kept;
  const Point2* first = nullptr;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!missing[i])
      kept.push_back(points[i]);
    else if (!first)
      first = &points[i];
  }
  if (!first)
    return;
  say_warning("{}: {} left out, the first y = {:g}, z = {:g}: no profile goes there, so that it marks a "
              "missing value",
              source, counted(points.size() - kept.size(), "point", "points"), first->y, first->z);
  points = std::move(kept);
}

} // namespace bem_contact
