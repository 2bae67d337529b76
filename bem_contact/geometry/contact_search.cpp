#include "bem_contact/geometry/contact_search.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <tuple>

namespace bem_contact {

namespace {

/// The rail as a height over y: from its highest point outwards to either side, as far as it can be seen
/// from above without looking past an edge.
class RailHeight {
public:
  explicit RailHeight(const WheelOnRail& pair) : rail_(pair.rail), pose_(pair.rail_pose) {
    const auto table = rail_.nodes();
    std::vector<Point2> p;
    p.reserve(table.size());
    const double c = std::cos(pose_.angle), s = std::sin(pose_.angle);
    for (const TabulatedProfile::Node& node : table)
      p.push_back(pose_.origin + Point2{c * node.position.y - s * node.position.z,
                                        s * node.position.y + c * node.position.z});
    const auto top = std::ranges::min_element(p, {}, &Point2::z) - p.begin();
    auto from = top, to = top;
    while (from > 0 && p[from - 1].y < p[from].y)
      --from;
    while (to + 1 < static_cast<std::ptrdiff_t>(p.size()) && p[to + 1].y > p[to].y)
      ++to;
    first_ = static_cast<int>(from);
    for (auto k = from; k <= to; ++k)
      y_.push_back(p[k].y);
  }

  double from() const { return y_.front(); }
  double to() const { return y_.back(); }

  struct Height {
    double z = 0, s = 0;
  };
  /// Nothing beyond its ends. `near`: where the search starts and, afterwards, where it ended.
  std::optional<Height> at(double y, int& near) const {
    if (!(y >= y_.front() && y <= y_.back()) || y_.size() < 2)
      return std::nullopt;
    const int last = static_cast<int>(y_.size()) - 2;
    near = std::clamp(near, 0, last);
    while (near > 0 && y < y_[near])
      --near;
    while (near < last && y > y_[near + 1])
      ++near;
    // Newton inside the bracket: y grows over the interval.
    double lo = 0, hi = 1, t = (y - y_[near]) / (y_[near + 1] - y_[near]);
    const double c = std::cos(pose_.angle), s = std::sin(pose_.angle);
    const auto nodes = rail_.nodes();
    const int k = first_ + near;
    const double length = nodes[k + 1].s - nodes[k].s;
    Height out;
    for (int i = 0; i < 30; ++i) {
      const TabulatedProfile::Point q = rail_.between(k, t);
      const double excess = pose_.origin.y + c * q.position.y - s * q.position.z - y;
      const double slope = length * (c * q.tangent.y - s * q.tangent.z);
      (excess > 0 ? hi : lo) = t;
      double next = slope > 0 ? t - excess / slope : -1;
      if (!(next >= lo && next <= hi))
        next = 0.5 * (lo + hi);
      const double step = next - t;
      t = next;
      if (std::abs(step) < 1e-13 || std::abs(excess) < 1e-13 * (1 + std::abs(y)))
        break;
    }
    const TabulatedProfile::Point q = rail_.between(k, t);
    out.z = pose_.origin.z + s * q.position.y + c * q.position.z;
    out.s = nodes[k].s + t * length;
    return out;
  }

private:
  TabulatedProfile rail_;
  Pose pose_;
  int first_ = 0;
  std::vector<double> y_; ///< of the nodes first_ .. that are seen
};

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

struct Search {
  const WheelOnRail& pair;
  ContactLocus locus{pair};
  RailHeight rail{pair};
  std::vector<double> distance{}; ///< of each node; NaN beside the rail
  int near = 0;

  ContactLocus::Point locus_at(double v) const {
    const int k = std::min(static_cast<int>(v), static_cast<int>(locus.nodes().size()) - 2);
    return locus.between(k, v - k);
  }
  /// v counts nodes: k + t between nodes k and k + 1.
  double distance_at(double v) {
    const ContactLocus::Point p = locus_at(v);
    const auto height = rail.at(p.position.y, near);
    return height ? height->z - p.position.z : std::numeric_limits<double>::infinity();
  }
  TouchPoint refined(int k, int from, int to);
};

TouchPoint Search::refined(int k, int from, int to) {
  // Golden section on the two stretches beside the node.
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double a = k - 1, b = k + 1, c = b - golden * (b - a), d = a + golden * (b - a);
  double fc = distance_at(c), fd = distance_at(d);
  while (b - a > 1e-7) {
    if (fc < fd) {
      b = d, d = c, fd = fc;
      c = b - golden * (b - a);
      fc = distance_at(c);
    } else {
      a = c, c = d, fc = fd;
      d = a + golden * (b - a);
      fd = distance_at(d);
    }
  }
  const double at = distance[k] < std::min(fc, fd) ? k : 0.5 * (a + b);
  const ContactLocus::Point p = locus_at(at);
  const auto height = rail.at(p.position.y, near);
  TouchPoint touch;
  touch.wheel_s = p.s;
  touch.x = p.x;
  touch.rail_s = height->s;
  touch.distance = height->z - p.position.z;
  touch.position = {p.position.y, height->z};
  touch.delta = pair.rail_at(touch.rail_s).delta;

  // How far it is flat on either side: to the node, then by bisection.
  const auto edge = [&](int step) {
    int i = step > 0 ? static_cast<int>(std::ceil(at)) : static_cast<int>(std::floor(at));
    double inside = at;
    for (; i >= from && i <= to && distance[i] <= touch.distance + flat_distance; i += step)
      inside = i;
    if (i < from || i > to)
      return inside;
    double outside = i;
    for (int n = 0; n < 20; ++n) {
      const double mid = 0.5 * (inside + outside);
      (distance_at(mid) <= touch.distance + flat_distance ? inside : outside) = mid;
    }
    return inside;
  };
  const double ends[2] = {edge(-1), edge(1)};
  double s[2];
  for (int i = 0; i < 2; ++i) {
    const auto h = rail.at(locus_at(ends[i]).position.y, near);
    s[i] = h ? h->s : touch.rail_s;
  }
  std::tie(touch.s_from, touch.s_to) = std::minmax(s[0], s[1]);
  return touch;
}

} // namespace

std::vector<TouchPoint> find_touch_points(const WheelOnRail& pair) {
  Search search{pair};
  const auto& nodes = search.locus.nodes();
  const int n = static_cast<int>(nodes.size());
  int above = 0;
  for (const ContactLocus::Node& node : nodes) {
    const auto height = search.rail.at(node.position.y, search.near);
    search.distance.push_back(height ? height->z - node.position.z : nowhere);
    above += height ? 1 : 0;
  }
  if (above < 3) {
    const auto [lo, hi] = std::ranges::minmax(nodes, {}, [](const auto& p) { return p.position.y; });
    throw InputError(
        "The wheel never meets the rail",
        fmt::format("the wheel spans y = {:.6g} .. {:.6g} mm and the rail {:.6g} .. {:.6g} mm", lo.position.y,
                    hi.position.y, search.rail.from(), search.rail.to()),
        "Check position.lateral, position.gauge, position.back_to_back and the sides of the profiles.");
  }

  // The locus runs back in y where it folds: on such a stretch the wheel is nearest to the rail somewhere
  // else along x. What is left are stretches on which y falls.
  std::vector<TouchPoint> points;
  int lowest_end = -1;
  for (int from = 0; from < n;) {
    int to = from;
    while (to + 1 < n && nodes[to + 1].joined && nodes[to + 1].position.y <= nodes[to].position.y &&
           std::isfinite(search.distance[to]) && std::isfinite(search.distance[to + 1]))
      ++to;
    if (std::isfinite(search.distance[from])) {
      const auto consider_end = [&](int k, int beyond) {
        const bool fold = beyond >= 0 && beyond < n && std::isfinite(search.distance[beyond]) &&
                          nodes[std::max(k, beyond)].joined;
        if (!fold && (lowest_end < 0 || search.distance[k] < search.distance[lowest_end]))
          lowest_end = k;
      };
      consider_end(from, from - 1);
      consider_end(to, to + 1);
      for (const int k : separate_minima(search.distance, from, to))
        points.push_back(search.refined(k, from, to));
    }
    from = to + 1;
  }
  std::ranges::sort(points, {}, &TouchPoint::distance);
  if (lowest_end >= 0 && (points.empty() || search.distance[lowest_end] < points.front().distance))
    throw InputError("The wheel touches the rail at the end of a profile",
                     fmt::format("the smallest vertical distance is at y = {:.2f} mm, where one of them ends",
                                 nodes[lowest_end].position.y),
                     "Check position.lateral and the extent of the profiles.");
  return points;
}

std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair) {
  std::vector<TouchPoint> points = find_touch_points(pair);
  if (points.empty())
    throw InputError("The wheel has no touch point on the rail", "the vertical distance has no minimum",
                     "Check the profiles.");
  const double drop = points.front().distance;
  pair.wheel_pose.origin.z += drop;
  for (TouchPoint& p : points)
    p.distance -= drop;
  return points;
}

} // namespace bem_contact
