#include "bem_contact/geometry/contact_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rail_height.hpp"
#include "bem_contact/geometry/rail_slices.hpp"
#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <tuple>

namespace bem_contact {

namespace {

/// 1 (node intervals, 0.1 mm each). How closely the end of a flat stretch is found.
constexpr double flat_end_width = 1e-6;

/// mm. On a roller and on a rail of sections, where touch points move as the wheel is lowered, it is lowered
/// until it moves by less. Each step leaves some 1e-4 of the one before.
constexpr double last_lowering = 1e-10;
/// 1. Such steps at most: four are usual. A bound.
constexpr int lowering_steps = 20;

/// 1 (cos of the inclination). A face of a rail of sections that is steeper, 89 degrees, is upright: a wheel
/// that is lowered passes along it, as a flange's back along a check rail. Chosen.
constexpr double least_upright = 0.0175;

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// Indices in (from, to) of local minima that a barrier separates from each other and from lower ends, the
/// lowest of each group.
std::vector<int> separate_minima(const std::vector<double>& distance, int from, int to) {
  std::vector<int> kept{from};
  for (int i = from + 1; i <= to; ++i) {
    if (i < to && !(distance[i] < distance[i - 1] && distance[i] <= distance[i + 1]))
      continue;
    int candidate = i;
    while (!kept.empty()) {
      const int other = kept.back();
      const double barrier = *std::max_element(distance.begin() + other, distance.begin() + candidate + 1);
      if (barrier - std::max(distance[other], distance[candidate]) >= flat_distance)
        break;
      candidate = distance[other] < distance[candidate] ? other : candidate;
      kept.pop_back();
    }
    kept.push_back(candidate);
  }
  std::erase_if(kept, [&](int k) { return k == from || k == to; });
  return kept;
}

/// The nodes of the locus with their distance from the rail, and what lies between them.
struct Search {
  const WheelOnRail& pair;
  const ContactLocus& locus;
  RailHeight rail{pair};
  std::vector<double> distance{}; ///< of each node; NaN beside the rail
  int near = 0;

  Search(const WheelOnRail& bodies, const ContactLocus& of_wheel);

  int nodes() const { return static_cast<int>(distance.size()); }
  bool above_rail(int k) const { return std::isfinite(distance[k]); }
  ContactLocus::Point locus_at(double v) const {
    const int k = std::min(static_cast<int>(v), nodes() - 2);
    return locus.between(k, v - k);
  }
  /// v counts nodes: k + t between nodes k and k + 1.
  double distance_at(double v) {
    const ContactLocus::Point p = locus_at(v);
    const auto height = rail.at(p.position.y, near);
    return height ? height->z - p.position.z : std::numeric_limits<double>::infinity();
  }
  int end_of_stretch(int from) const;
  bool ends_at(int k, int beyond) const;
  TouchPoint refined(int k, int from, int to);
  std::pair<double, double> flat_stretch(const TouchPoint& touch, double at, int from, int to);
};

Search::Search(const WheelOnRail& bodies, const ContactLocus& of_wheel) : pair(bodies), locus(of_wheel) {
  int above = 0;
  for (const ContactLocus::Node& node : locus.nodes()) {
    const auto height = rail.at(node.position.y, near);
    distance.push_back(height ? height->z - node.position.z : nowhere);
    above += height ? 1 : 0;
  }
  if (above >= 3)
    return;
  const auto [lo, hi] = std::ranges::minmax(locus.nodes(), {}, [](const auto& p) { return p.position.y; });
  throw InputError(
      "The wheel never meets the rail",
      fmt::format("the wheel spans y = {:.6g} .. {:.6g} mm and the rail {:.6g} .. {:.6g} mm", lo.position.y,
                  hi.position.y, rail.from(), rail.to()),
      "Check position.lateral, position.gauge, position.back_to_back and the sides of the profiles.");
}

/// The locus runs back in y where it folds: on such a stretch the wheel is nearest to the rail somewhere else
/// along x. What is left are stretches on which y falls.
int Search::end_of_stretch(int from) const {
  const auto& node = locus.nodes();
  int to = from;
  while (to + 1 < nodes() && node[to + 1].joined && node[to + 1].position.y <= node[to].position.y &&
         above_rail(to) && above_rail(to + 1))
    ++to;
  return to;
}

/// Whether a stretch that ends at node k, next to node `beyond`, ends there with a profile, not in a fold.
bool Search::ends_at(int k, int beyond) const {
  const bool fold =
      beyond >= 0 && beyond < nodes() && above_rail(beyond) && locus.nodes()[std::max(k, beyond)].joined;
  return !fold;
}

/// The minimum near node k of the stretch from .. to.
TouchPoint Search::refined(int k, int from, int to) {
  const auto [beside, least] = boost::math::tools::brent_find_minima(
      [&](double t) { return std::min(distance_at(k + t), excluded_gap); }, -1.0, 1.0,
      std::numeric_limits<double>::digits / 2);
  const double at = distance[k] < least ? k : k + beside;
  const ContactLocus::Point p = locus_at(at);
  const auto height = rail.at(p.position.y, near);
  TouchPoint touch;
  touch.wheel_s = p.s;
  touch.x = p.x;
  touch.ahead = p.ahead;
  touch.rail_s = height->s;
  touch.distance = height->z - p.position.z;
  touch.position = {p.position.y, height->z};
  touch.delta = pair.rail_at(touch.rail_s).delta;
  std::tie(touch.s_from, touch.s_to) = flat_stretch(touch, at, from, to);
  return touch;
}

/// Arc lengths on the rail between which the distance stays within flat_distance of the touch point's: on
/// either side to the last such node, then by bisection.
std::pair<double, double> Search::flat_stretch(const TouchPoint& touch, double at, int from, int to) {
  const double limit = touch.distance + flat_distance;
  const auto end = [&](int step) {
    int i = step > 0 ? static_cast<int>(std::ceil(at)) : static_cast<int>(std::floor(at));
    double inside = at;
    for (; i >= from && i <= to && distance[i] <= limit; i += step)
      inside = i;
    if (i < from || i > to)
      return inside;
    for (double outside = i; std::abs(outside - inside) > flat_end_width;) {
      const double middle = std::midpoint(inside, outside);
      (distance_at(middle) <= limit ? inside : outside) = middle;
    }
    return inside;
  };
  const double ends[2] = {end(-1), end(1)};
  double s[2];
  for (int i = 0; i < 2; ++i) {
    const auto h = rail.at(locus_at(ends[i]).position.y, near);
    s[i] = h ? h->s : touch.rail_s;
  }
  return std::minmax(s[0], s[1]);
}

std::vector<TouchPoint> touch_points(const WheelOnRail& pair, const ContactLocus& locus) {
  Search search(pair, locus);
  std::vector<TouchPoint> points;
  int lowest_end = -1;
  for (int from = 0, to = 0; from < search.nodes(); from = to + 1) {
    to = search.end_of_stretch(from);
    if (!search.above_rail(from))
      continue;
    for (const auto& [end, beyond] : {std::pair(from, from - 1), std::pair(to, to + 1)})
      if (search.ends_at(end, beyond) &&
          (lowest_end < 0 || search.distance[end] < search.distance[lowest_end]))
        lowest_end = end;
    for (const int k : separate_minima(search.distance, from, to))
      points.push_back(search.refined(k, from, to));
  }
  std::ranges::sort(points, {}, &TouchPoint::distance);
  if (lowest_end >= 0 && (points.empty() || search.distance[lowest_end] < points.front().distance))
    throw InputError("The wheel touches the rail at the end of a profile",
                     fmt::format("the smallest vertical distance is at y = {:.2f} mm, where one of them ends",
                                 search.locus.nodes()[lowest_end].position.y),
                     "Check position.lateral and the extent of the profiles.");
  return points;
}

/// The touch points of a rail of sections: least distances of its rows, with their relief.
class TouchOnSections {
public:
  TouchOnSections(const WheelOnRail& pair, const ContactLocus& locus) : pair_(pair), locus_(locus) {}

  /// Of all slices of the head.
  std::vector<TouchPoint> points() const {
    const std::vector<RailSlice> slices = slice_rail(pair_, locus_);
    std::vector<double> distance;
    distance.reserve(slices.size());
    for (const RailSlice& slice : slices)
      distance.push_back(vertical(slice.gap, slice.delta));
    std::vector<TouchPoint> out;
    const int last = static_cast<int>(slices.size()) - 1;
    if (last < 2)
      return out;
    for (const int k : separate_minima(distance, 0, last)) {
      if (distance[k] >= excluded_gap)
        continue;
      TouchPoint touch = refined(slices[k].s);
      for (int i = k; i >= 0 && distance[i] <= touch.distance + flat_distance; --i)
        touch.s_from = std::min(touch.s_from, slices[i].s);
      for (int i = k; i <= last && distance[i] <= touch.distance + flat_distance; ++i)
        touch.s_to = std::max(touch.s_to, slices[i].s);
      out.push_back(touch);
    }
    std::ranges::sort(out, {}, &TouchPoint::distance);
    return out;
  }
  /// The same ones where the wheel stands now.
  std::vector<TouchPoint> again(const std::vector<TouchPoint>& before) const {
    std::vector<TouchPoint> out;
    for (const TouchPoint& touch : before) {
      TouchPoint now = refined(touch.rail_s);
      now.s_from = std::min(touch.s_from, now.rail_s);
      now.s_to = std::max(touch.s_to, now.rail_s);
      out.push_back(now);
    }
    std::ranges::sort(out, {}, &TouchPoint::distance);
    return out;
  }

private:
  double upright(double delta) const { return std::cos(delta) * pair_.upright(); }
  /// How far the wheel may be lowered until it touches a row at this distance along the normal.
  double vertical(double gap, double delta) const {
    return gap < excluded_gap && upright(delta) > least_upright ? gap / upright(delta) : excluded_gap;
  }
  std::pair<RowOnLocus, ContactRow> row_at(double s) const {
    const CurvePoint p = pair_.rail_at(s);
    const ContactRow row{p.s, p.position, p.delta};
    return {with_relief(pair_, row, rows_on_locus(locus_, std::span(&row, 1)).front()), row};
  }
  TouchPoint refined(double near) const {
    const auto distance = [&](double s) {
      const auto [on, row] = row_at(s);
      return on.hit() ? vertical(on.distance, row.delta) : excluded_gap;
    };
    const double from = std::max(near - slice_width, pair_.rail.s_begin()),
                 to = std::min(near + slice_width, pair_.rail.s_end());
    const auto [s, least] =
        boost::math::tools::brent_find_minima(distance, from, to, std::numeric_limits<double>::digits / 2);
    const double at = distance(near) <= least ? near : s;
    const auto [on, row] = row_at(at);
    const Vector3 p = pair_.sections->point(on.x, row);
    return {at, on.wheel_s, on.x, {p[1], p[2]}, row.delta, vertical(on.distance, row.delta), at, at};
  }

  const WheelOnRail& pair_;
  const ContactLocus& locus_;
};

void lower(WheelOnRail& pair, ContactLocus& locus, double by) {
  pair.wheel_pose.origin.z += by;
  locus.lower(by);
}

/// At first to the prism: from far away slices see no wheel.
void bring_near(WheelOnRail& pair, ContactLocus& locus) {
  const std::vector<TouchPoint> points = touch_points(pair, locus);
  if (!points.empty())
    lower(pair, locus, points.front().distance / pair.upright());
}

} // namespace

std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair) {
  ContactLocus locus(pair);
  return lower_to_touch(pair, locus);
}

std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair, ContactLocus& locus) {
  // On a straight rail the first step is exact.
  const bool moves = pair.roller || pair.sections;
  if (pair.sections)
    bring_near(pair, locus);
  std::vector<TouchPoint> points;
  for (int step = 1;; ++step) {
    const TouchOnSections sections(pair, locus);
    points = !pair.sections ? touch_points(pair, locus)
             : step == 1    ? sections.points()
                            : sections.again(points);
    if (points.empty())
      throw InputError("The wheel has no touch point on the rail", "the vertical distance has no minimum",
                       "Check the profiles.");
    const double drop = points.front().distance;
    lower(pair, locus, drop);
    for (TouchPoint& p : points)
      p.distance -= drop;
    if (!moves || std::abs(drop) < last_lowering || step == lowering_steps)
      return points;
  }
}

} // namespace bem_contact
