#include "bem_contact/wheelset/placement.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

constexpr double search_step = 0.02; // mm, of the sampled profiles

Point2 turned(Point2 p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.y - s * p.z, s * p.y + c * p.z};
}

struct Sampled {
  std::vector<double> s;
  std::vector<Point2> p; // track frame
};

Sampled sample(const ProfileCurve& curve, const Pose& pose) {
  const double length = curve.s_end() - curve.s_begin();
  const int n = std::max(2, static_cast<int>(std::ceil(length / search_step)));
  Sampled out;
  for (int i = 0; i <= n; ++i) {
    const double s = i == n ? curve.s_end() : curve.s_begin() + length * i / n;
    out.s.push_back(s);
    out.p.push_back(pose.to_track(curve.at(s).position));
  }
  return out;
}

/// One profile as a height over y: of the points above each other the one that faces the other body.
struct Envelope {
  std::vector<double> z, s; // NaN where the profile does not reach
};

Envelope envelope(const Sampled& curve, double y0, double dy, int n, double sign) {
  Envelope out{std::vector<double>(n, std::numeric_limits<double>::quiet_NaN()),
               std::vector<double>(n, std::numeric_limits<double>::quiet_NaN())};
  for (std::size_t k = 0; k + 1 < curve.p.size(); ++k) {
    const Point2 a = curve.p[k], b = curve.p[k + 1];
    const int from = std::max(0, static_cast<int>(std::ceil((std::min(a.y, b.y) - y0) / dy)));
    const int to = std::min(n - 1, static_cast<int>(std::floor((std::max(a.y, b.y) - y0) / dy)));
    for (int i = from; i <= to; ++i) {
      const double t = a.y == b.y ? 0.0 : (y0 + i * dy - a.y) / (b.y - a.y);
      const double z = a.z + t * (b.z - a.z);
      if (!(sign * z <= sign * out.z[i])) {
        out.z[i] = z;
        out.s[i] = curve.s[k] + t * (curve.s[k + 1] - curve.s[k]);
      }
    }
  }
  return out;
}

/// Arc length near `guess` at which the wheel is at track coordinate y (bisection: steep parts included).
double wheel_s_at_y(const WheelOnRail& pair, double y, double guess) {
  const auto f = [&](double s) { return pair.wheel_at(s).position.y - y; };
  double reach = 2 * search_step;
  double lo = std::max(guess - reach, pair.wheel.s_begin()), hi = std::min(guess + reach, pair.wheel.s_end());
  while (f(lo) * f(hi) > 0 && reach < 4) {
    reach *= 2;
    lo = std::max(guess - reach, pair.wheel.s_begin());
    hi = std::min(guess + reach, pair.wheel.s_end());
  }
  const bool falling = f(lo) > f(hi);
  for (int i = 0; i < 60; ++i) {
    const double mid = 0.5 * (lo + hi);
    ((f(mid) > 0) == falling ? lo : hi) = mid;
  }
  return 0.5 * (lo + hi);
}

// Two minima with less than this between them are one: less than the chords of the samples can hide, mm.
constexpr double least_barrier = 2e-5;

/// Indices of the local minima that a barrier of at least least_barrier separates, the lowest of each group.
std::vector<int> separate_minima(const std::vector<double>& distance) {
  std::vector<int> kept;
  for (int i = 1; i + 1 < static_cast<int>(distance.size()); ++i) {
    if (!(distance[i] < distance[i - 1] && distance[i] <= distance[i + 1]))
      continue;
    int candidate = i;
    while (!kept.empty()) {
      const int other = kept.back();
      const double barrier = *std::max_element(distance.begin() + other, distance.begin() + candidate);
      if (barrier - std::max(distance[other], distance[candidate]) >= least_barrier)
        break;
      candidate = distance[other] < distance[candidate] ? other : candidate;
      kept.pop_back();
    }
    kept.push_back(candidate);
  }
  return kept;
}

} // namespace

Point2 Pose::to_track(Point2 section) const {
  return origin + turned(section, angle);
}
Point2 Pose::to_section(Point2 track) const {
  return turned(track - origin, -angle);
}

CurvePoint WheelOnRail::rail_at(double s) const {
  CurvePoint p = rail.at(s);
  p.position = rail_pose.to_track(p.position);
  p.delta += rail_pose.angle;
  return p;
}

CurvePoint WheelOnRail::wheel_at(double s) const {
  CurvePoint p = wheel.at(s);
  p.position = wheel_pose.to_track(p.position);
  p.delta += wheel_pose.angle;
  return p;
}

WheelOnRail place(const SceneFile::Position& position, ProfileCurve rail, ProfileCurve wheel) {
  WheelOnRail pair{std::move(rail),
                   std::move(wheel),
                   {{0, 0}, -position.cant},
                   {{0, 0}, position.roll},
                   position.wheel_radius};

  const Sampled head = sample(pair.rail, pair.rail_pose);
  const auto top = std::ranges::min_element(head.p, {}, &Point2::z);
  const double gauge_z = top->z + position.gauge_height;
  double gauge_y = top->y;
  bool reached = false;
  for (auto p = top;; --p) {
    if (p->z >= gauge_z) {
      const Point2 q = *(p + 1); // between p and q the profile passes the gauge height
      gauge_y = std::min(gauge_y, q.y + (p->y - q.y) * (gauge_z - q.z) / (p->z - q.z));
      reached = true;
      break;
    }
    gauge_y = std::min(gauge_y, p->y);
    if (p == head.p.begin())
      break;
  }
  if (!reached)
    throw InputError(fmt::format("The rail '{}' has no gauge face", pair.rail.name()),
                     fmt::format("its profile ends less than {} mm below its top on the gauge side (-y)",
                                 position.gauge_height),
                     "Give a profile that reaches further down, or a smaller position.gauge_height.");
  pair.rail_pose.origin = {position.gauge / 2 - gauge_y, -top->z};

  const Point2 tape{position.back_to_back / 2 + flange_back_to_tape_circle, position.wheel_radius};
  pair.wheel_pose.origin = Point2{position.lateral, -position.wheel_radius} + turned(tape, position.roll);
  return pair;
}

std::vector<TouchPoint> find_touch_points(const WheelOnRail& pair) {
  const Sampled rail = sample(pair.rail, pair.rail_pose), wheel = sample(pair.wheel, pair.wheel_pose);
  const auto [rail_lo, rail_hi] = std::ranges::minmax(rail.p, {}, &Point2::y);
  const auto [wheel_lo, wheel_hi] = std::ranges::minmax(wheel.p, {}, &Point2::y);
  const double y0 = std::max(rail_lo.y, wheel_lo.y), y1 = std::min(rail_hi.y, wheel_hi.y);
  const double dy = 0.02;
  const int n = static_cast<int>(std::floor((y1 - y0) / dy)) + 1;
  if (!(y1 > y0) || n < 5)
    throw InputError(
        "The wheel never meets the rail",
        fmt::format("the wheel spans y = {:.1f} .. {:.1f} mm and the rail {:.1f} .. {:.1f} mm", wheel_lo.y,
                    wheel_hi.y, rail_lo.y, rail_hi.y),
        "Check position.lateral, position.gauge, position.back_to_back and the sides of the profiles.");

  const Envelope below = envelope(rail, y0, dy, n, -1.0), above = envelope(wheel, y0, dy, n, 1.0);
  std::vector<double> distance(n);
  for (int i = 0; i < n; ++i)
    distance[i] = below.z[i] - above.z[i];

  // Golden section on the exact curves inside the bracket of each sampled minimum.
  const auto exact = [&](double rail_s, double wheel_guess, double& wheel_s) {
    const Point2 p = pair.rail_at(rail_s).position;
    wheel_s = wheel_s_at_y(pair, p.y, wheel_guess);
    return p.z - pair.wheel_at(wheel_s).position.z;
  };
  std::vector<TouchPoint> points;
  int deepest = -1;
  for (int i = 0; i < n; ++i)
    if (!std::isnan(distance[i]) && (deepest < 0 || distance[i] < distance[deepest]))
      deepest = i;
  if (deepest < 1 || deepest > n - 2)
    throw InputError("The wheel touches the rail at the end of a profile",
                     fmt::format("the smallest vertical distance is at y = {:.2f} mm, where one of them ends",
                                 y0 + std::max(deepest, 0) * dy),
                     "Check position.lateral and the extent of the profiles.");

  for (const int sampled : separate_minima(distance)) {
    // The chords of the samples hide where on a conformal stretch the minimum is: scan it exactly.
    int i = sampled;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = std::max(1, sampled - 25); k <= std::min(n - 2, sampled + 25); ++k) {
      if (std::isnan(distance[k]) || distance[k] > distance[sampled] + least_barrier)
        continue;
      double wheel_s = 0;
      const double h = exact(below.s[k], above.s[k], wheel_s);
      if (h < lowest)
        lowest = h, i = k;
    }
    double a = std::min(below.s[i - 1], below.s[i + 1]), b = std::max(below.s[i - 1], below.s[i + 1]);
    const double golden = 0.5 * (std::sqrt(5.0) - 1);
    double wheel_s = above.s[i];
    double c = b - golden * (b - a), d = a + golden * (b - a);
    double fc = exact(c, above.s[i], wheel_s), fd = exact(d, above.s[i], wheel_s);
    while (b - a > 1e-7) {
      if (fc < fd) {
        b = d, d = c, fd = fc;
        c = b - golden * (b - a);
        fc = exact(c, above.s[i], wheel_s);
      } else {
        a = c, c = d, fc = fd;
        d = a + golden * (b - a);
        fd = exact(d, above.s[i], wheel_s);
      }
    }
    TouchPoint touch;
    touch.rail_s = 0.5 * (a + b);
    touch.distance = exact(touch.rail_s, above.s[i], touch.wheel_s);
    const CurvePoint p = pair.rail_at(touch.rail_s);
    touch.position = p.position;
    touch.delta = p.delta;
    points.push_back(touch);
  }
  std::ranges::sort(points, {}, &TouchPoint::distance);
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
