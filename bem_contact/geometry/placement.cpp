#include "bem_contact/geometry/placement.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

Point2 turned(Point2 p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.y - s * p.z, s * p.y + c * p.z};
}

/// t in [0, 1] at which f, positive at 0 and not at 1, vanishes.
template <class F> double where_it_vanishes(const F& f) {
  double lo = 0, hi = 1;
  for (int i = 0; i < 52; ++i) {
    const double mid = 0.5 * (lo + hi);
    (f(mid) > 0 ? lo : hi) = mid;
  }
  return hi;
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

WheelFrame WheelOnRail::wheel_frame() const {
  const double c = std::cos(yaw), s = std::sin(yaw);
  const double cosine = std::cos(wheel_pose.angle), sine = std::sin(wheel_pose.angle);
  const Point2 centre = wheel_pose.to_track({0, -wheel_radius});
  const double arm = centre.y - centre_y;
  return {{-s * arm, centre_y + c * arm, centre.z},
          {c, s, 0},
          {-s * cosine, c * cosine, sine},
          {s * sine, -c * sine, cosine}};
}

WheelOnRail place(const SceneFile::Position& position, TabulatedProfile rail, TabulatedProfile wheel) {
  // Roll and yaw are axial vectors in the plane that mirrors left and right: they change sign with y.
  const double side = position.side == WheelSide::left ? -1 : 1;
  WheelOnRail pair{
      std::move(rail),       std::move(wheel),    {{0, 0}, -position.cant}, {{0, 0}, side * position.roll},
      position.wheel_radius, side * position.yaw, side * position.lateral};

  for (const TabulatedProfile::Node& node : pair.wheel.nodes())
    if (!(position.wheel_radius + node.position.z > 0))
      throw InputError(
          fmt::format("The wheel '{}' reaches beyond its axle", pair.wheel.name()),
          fmt::format("its radius at y = {:.4g} mm would be {:.4g} mm: position.wheel_radius is {:g} mm",
                      node.position.y, position.wheel_radius + node.position.z, position.wheel_radius),
          "Give the nominal radius, at the tape circle, in mm.");

  const auto nodes = pair.rail.nodes();
  const auto at = [&](int k, double t) { return pair.rail_pose.to_track(pair.rail.between(k, t).position); };
  std::vector<Point2> head;
  for (const TabulatedProfile::Node& node : nodes)
    head.push_back(pair.rail_pose.to_track(node.position));
  // The exact extreme lies in one of the two intervals at the extreme node.
  const auto extreme = [&](int k, double Point2::*coordinate) {
    double least = head[k].*coordinate;
    for (const int i : {k - 1, k}) {
      if (i < 0 || i + 1 >= static_cast<int>(head.size()))
        continue;
      const auto slope = [&](double t) {
        return turned(pair.rail.between(i, t).tangent, pair.rail_pose.angle).*coordinate;
      };
      if (slope(0) < 0 && slope(1) > 0)
        least = std::min(least, at(i, where_it_vanishes([&](double t) { return -slope(t); })).*coordinate);
    }
    return least;
  };

  const int top = static_cast<int>(std::ranges::min_element(head, {}, &Point2::z) - head.begin());
  const double top_z = extreme(top, &Point2::z), gauge_z = top_z + position.gauge_height;
  int below = top;
  while (below >= 0 && head[below].z < gauge_z)
    --below;
  if (below < 0)
    throw InputError(fmt::format("The rail '{}' has no gauge face", pair.rail.name()),
                     fmt::format("its profile ends less than {} mm below its top on the gauge side (-y)",
                                 position.gauge_height),
                     "Give a profile that reaches further down, or a smaller position.gauge_height.");
  const double t = where_it_vanishes([&](double u) { return at(below, u).z - gauge_z; });
  const int innermost = static_cast<int>(
      std::ranges::min_element(head.begin() + below + 1, head.begin() + top + 1, {}, &Point2::y) -
      head.begin());
  double gauge_y = at(below, t).y;
  if (head[innermost].y < gauge_y)
    gauge_y = std::min(gauge_y, extreme(innermost, &Point2::y));
  pair.rail_pose.origin = Point2{position.gauge / 2 - gauge_y, -top_z} +
                          Point2{side * position.rail_lateral, position.rail_vertical};
  pair.rail_pose.angle += side * position.rail_roll;

  const Point2 tape{position.back_to_back / 2 + flange_back_to_tape_circle, position.wheel_radius};
  pair.wheel_pose.origin =
      Point2{pair.centre_y, -position.wheel_radius} + turned(tape, pair.wheel_pose.angle);
  return pair;
}

} // namespace bem_contact
