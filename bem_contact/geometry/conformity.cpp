#include "bem_contact/geometry/conformity.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/profile/running_head.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bem_contact {

namespace {

/// mm. Borders of the classes, and the longest stretch that is looked at (Magel and Kalousek, Wear 253 (2002)
/// 308).
constexpr double closely = 0.1, loosely = 0.4;
constexpr double farthest_s = 20.0; ///< mm. As above.
/// mm. Steps along s. Between them the distance is linear to 0.0015 mm at a radius of 13 mm.
constexpr double step = 0.4;
/// mm. Displacements among which that of the flange is sought, and how far apart the first are: beyond the
/// play of the thinnest flange, and less than the way from tread to flange.
constexpr double least_lateral = -10.0, most_lateral = 25.0;
constexpr double lateral_step = 1.0; ///< mm. As above.
/// mm. How closely that displacement is found.
constexpr double lateral_tolerance = 1e-4;

/// The arc length at which the rail's gauge side is first `depth` below its top; its end where it is not.
double gauge_point(const WheelOnRail& pair, double depth) {
  const auto nodes = pair.rail.nodes();
  std::vector<Point2> at;
  for (const TabulatedProfile::Node& node : nodes)
    at.push_back(pair.rail_pose.to_track(node.position));
  const std::size_t top = top_of_running_head(at, depth);
  for (std::size_t k = top; k-- > 0;)
    if (const double wanted = at[top].z + depth; at[k].z >= wanted)
      return nodes[k + 1].s +
             (nodes[k].s - nodes[k + 1].s) * (wanted - at[k + 1].z) / (at[k].z - at[k + 1].z);
  return nodes.front().s;
}

/// Distances at steps from the touching point to one side, the first of them 0 at it.
struct Side {
  std::vector<double> s, distance, wheel_s;
};

/// Towards `end`. Ends before where the rail ends or a normal misses the wheel.
Side one_side(const WheelOnRail& pair, const ContactLocus& locus, const TouchPoint& touch, double end) {
  const double from = touch.rail_s;
  Side out{{from}, {0}, {touch.wheel_s}};
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(end - from) / step)));
  std::vector<double> s;
  for (int k = 0; k <= count; ++k)
    s.push_back(std::lerp(from, end, double(k) / count)); // exact at both ends
  const bool down = end < from;
  if (down)
    std::ranges::reverse(s);
  std::vector<RowOnLocus> rows = rows_on_locus(locus, rail_rows(pair, s, 0));
  if (down) {
    std::ranges::reverse(s);
    std::ranges::reverse(rows);
  }
  for (std::size_t k = 1; k < s.size() && rows[k].hit(); ++k) {
    out.s.push_back(s[k]);
    out.distance.push_back(rows[k].distance);
    out.wheel_s.push_back(rows[k].wheel_s);
  }
  return out;
}

/// Where the distance first exceeds `closely`, on both bodies; the last place where it does not.
struct Place {
  double rail_s = 0, wheel_s = 0;
};
Place edge(const Side& side) {
  for (std::size_t k = 1; k < side.s.size(); ++k)
    if (side.distance[k] > closely) {
      // Round surfaces part as a parabola: the root of the distance is linear.
      const double before = std::sqrt(std::max(0.0, side.distance[k - 1])),
                   after = std::sqrt(side.distance[k]);
      const double t = (std::sqrt(closely) - before) / (after - before);
      return {side.s[k - 1] + t * (side.s[k] - side.s[k - 1]),
              side.wheel_s[k - 1] + t * (side.wheel_s[k] - side.wheel_s[k - 1])};
    }
  return {side.s.back(), side.wheel_s.back()};
}

double mean_radius(const TabulatedProfile& profile, double from, double to) {
  const double turn = profile.at(to).delta - profile.at(from).delta;
  return turn == 0 ? std::numeric_limits<double>::infinity() : (to - from) / turn;
}

/// The wheel as it first touches at a displacement towards its own side.
struct Lowered {
  WheelOnRail pair;
  TouchPoint touch;
};

Lowered lowered_at(WheelsetPosition position, double lateral, const TabulatedProfile& rail,
                   const TabulatedProfile& wheel) {
  position.lateral = lateral;
  position.yaw = 0;
  position.deviation.yaw = 0;
  Lowered out{place(position, rail, wheel), {}};
  out.touch = lower_to_touch(out.pair).front();
  return out;
}

/// rad. Of the flank of its flange, towards the rail.
double flange_inclination(const TabulatedProfile& wheel) {
  double most = 0;
  for (const TabulatedProfile::Node& node : wheel.nodes())
    if (node.position.y < 0)
      most = std::max(most, std::atan2(node.after.z, -node.after.y));
  return most;
}

} // namespace

std::string_view words_of(Fit fit) {
  return fit == Fit::closely_conformal ? "closely conformal"
         : fit == Fit::conformal       ? "conformal"
                                       : "not conformal";
}

Fit Conformity::fit() const {
  return largest < closely    ? Fit::closely_conformal
         : largest <= loosely ? Fit::conformal
                              : Fit::not_conformal;
}

Conformity conformity(const WheelOnRail& pair, const TouchPoint& touch, double gauge_height) {
  const ContactLocus locus(pair);
  const double s = touch.rail_s, gauge = gauge_point(pair, gauge_height);
  Conformity out{.rail_s = s, .wheel_s = touch.wheel_s, .delta = touch.delta};
  out.end_s = std::clamp(gauge, s - farthest_s, s + farthest_s);
  const Side towards = one_side(pair, locus, touch, out.end_s);
  const bool down = out.end_s < s; // the gauge lies there
  for (std::size_t k = 0; k < towards.s.size(); ++k)
    if (towards.distance[k] >= out.largest) {
      out.largest = towards.distance[k];
      out.largest_s = towards.s[k];
    }
  if (towards.s.back() != out.end_s) { // its normal misses the wheel: it is far away
    out.largest = excluded_gap;
    out.largest_s = out.end_s;
  }
  // The stretch towards the gauge serves for the width too where it goes beyond `closely`.
  const auto border = [&](double end) {
    return edge((end < s) == down && out.largest > closely ? towards : one_side(pair, locus, touch, end));
  };
  const Place low = border(std::max(s - farthest_s, pair.rail.s_begin())),
              high = border(std::min(s + farthest_s, pair.rail.s_end()));
  out.width = high.rail_s - low.rail_s;
  out.turn = std::abs(pair.rail.at(high.rail_s).delta - pair.rail.at(low.rail_s).delta);
  out.rail_radius = mean_radius(pair.rail, low.rail_s, high.rail_s);
  out.wheel_radius = mean_radius(pair.wheel, high.wheel_s, low.wheel_s);
  return out;
}

Conformity conformity_at(const WheelsetPosition& position, const TabulatedProfile& rail,
                         const TabulatedProfile& wheel) {
  const Lowered there = lowered_at(position, position.lateral, rail, wheel);
  Conformity out = conformity(there.pair, there.touch, position.gauge_height);
  out.lateral = position.lateral;
  return out;
}

std::optional<Conformity> conformity_at_flange(const WheelsetPosition& position, const TabulatedProfile& rail,
                                               const TabulatedProfile& wheel) {
  const double half = 0.5 * flange_inclination(wheel);
  const double side = position.side == WheelSide::left ? -1 : 1;
  const auto on_flange = [&](double towards) -> std::optional<bool> {
    try {
      return lowered_at(position, side * towards, rail, wheel).touch.delta < -half;
    } catch (const InputError&) { // the wheel is not above the rail
      return std::nullopt;
    }
  };
  std::optional<double> before, after;
  for (double y = least_lateral; y <= most_lateral && !after; y += lateral_step)
    if (const std::optional<bool> there = on_flange(y))
      (*there ? after : before) = y;
  if (!before || !after)
    return std::nullopt;
  while (*after - *before > lateral_tolerance) {
    const double middle = 0.5 * (*before + *after);
    (on_flange(middle).value_or(true) ? after : before) = middle;
  }
  WheelsetPosition there = position;
  there.lateral = side * *before;
  return conformity_at(there, rail, wheel);
}

} // namespace bem_contact
