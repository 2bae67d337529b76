#include "bem_contact/geometry/placement.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/contact_search.hpp"
#include "bem_contact/profile/running_head.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>
#include <utility>

namespace bem_contact {

namespace {

/// t in [0, 1] at which f, positive at 0 and not at 1, vanishes.
template <class F> double where_it_vanishes(const F& f) {
  if (!(f(0.0) > 0) || f(1.0) > 0) // but for rounding
    return f(0.0) > 0 ? 1.0 : 0.0;
  return boost::math::tools::bisect(f, 0.0, 1.0, boost::math::tools::eps_tolerance<double>()).second;
}

void require_axle_above(const TabulatedProfile& wheel, double wheel_radius) {
  for (const TabulatedProfile::Node& node : wheel.nodes())
    if (!(wheel_radius + node.position.z > 0))
      throw InputError(
          fmt::format("The wheel '{}' reaches beyond its axle", wheel.name()),
          fmt::format("its radius at y = {:.4g} mm would be {:.4g} mm: position.wheel_radius is {:g} mm",
                      node.position.y, wheel_radius + node.position.z, wheel_radius),
          "Give the nominal radius, at the tape circle, in mm.");
}

void require_axis_below(const WheelOnRail& pair) {
  for (const TabulatedProfile::Node& node : pair.rail.nodes())
    if (const Point2 p = pair.rail_pose.to_track(node.position); !(pair.roller->radius(p) > 0))
      throw InputError(fmt::format("The rail '{}' reaches beyond the axis of its roller", pair.rail.name()),
                       fmt::format("it goes down to z = {:.4g} mm, and the axis is at z = {:.4g} mm", p.z,
                                   pair.roller->axis),
                       "Give the radius of the roller's surface, rail.roller_radius, in mm.");
}

/// The rail's running head as it is inclined, about the origin of its section.
class Head {
public:
  Head(const TabulatedProfile& rail, double angle, double gauge_height)
      : rail_(rail), turn_(angle), gauge_height_(gauge_height) {
    nodes_.reserve(rail.nodes().size());
    for (const TabulatedProfile::Node& node : rail.nodes())
      nodes_.push_back(turn_(node.position));
    top_ = static_cast<int>(top_of_running_head(nodes_, gauge_height));
  }

  double top() const { return extreme(top_, &Point2::z); }
  /// Least y between the top and the gauge height below it. Throws InputError where the rail ends before.
  double gauge_face() const {
    const double gauge_z = top() + gauge_height_;
    int below = top_;
    while (below >= 0 && nodes_[below].z < gauge_z)
      --below;
    if (below < 0)
      throw InputError(
          fmt::format("The rail '{}' has no gauge face", rail_.name()),
          fmt::format("its profile ends less than {} mm below its top on the gauge side (-y)", gauge_height_),
          "Give a profile that reaches further down, a smaller position.gauge_height, or rail.place = "
          "\"absolute\" with rail.y and rail.z.");
    const double t = where_it_vanishes([&](double u) { return at(below, u).z - gauge_z; });
    const int innermost = static_cast<int>(
        std::ranges::min_element(nodes_.begin() + below + 1, nodes_.begin() + top_ + 1, {}, &Point2::y) -
        nodes_.begin());
    const double face = at(below, t).y;
    return nodes_[innermost].y < face ? std::min(face, extreme(innermost, &Point2::y)) : face;
  }

private:
  Point2 at(int k, double t) const { return turn_(rail_.between(k, t).position); }
  /// The exact least value lies in one of the two intervals at the node of least value.
  double extreme(int k, double Point2::*coordinate) const {
    double least = nodes_[k].*coordinate;
    for (const int i : {k - 1, k}) {
      if (i < 0 || i + 1 >= static_cast<int>(nodes_.size()))
        continue;
      const auto slope = [&](double t) { return turn_(rail_.between(i, t).tangent).*coordinate; };
      if (slope(0) < 0 && slope(1) > 0)
        least = std::min(least, at(i, where_it_vanishes([&](double t) { return -slope(t); })).*coordinate);
    }
    return least;
  }

  const TabulatedProfile& rail_;
  Turn turn_;
  double gauge_height_; ///< mm
  std::vector<Point2> nodes_;
  int top_ = 0;
};

/// Where the origin of the rail's section stands in the track frame.
Point2 rail_origin(const WheelsetPosition& position, const TabulatedProfile& rail, double angle) {
  if (position.rail_origin)
    return *position.rail_origin;
  const Head head(rail, angle, position.gauge_height);
  return {position.gauge / 2 - head.gauge_face(), -head.top()};
}

/// 1. Frames from which a rail of sections is looked at, one after the other: four are usual, and where the
/// wheel touches at two places of other slopes they go on changing.
constexpr int frames_tried = 8;
/// 1 (of unit vectors) and mm. A frame that changes by less stays.
constexpr double same_direction = 1e-9;
constexpr double same_origin = 1e-4; ///< mm. As above.

/// Lays the frame along the surface where the wheel touches, which depends on the frame.
void look_from_touch(WheelOnRail& pair, SectionedRail rail) {
  RailFrame frame;
  for (int i = 0; i < frames_tried; ++i) {
    pair.rail = rail.look_from(frame);
    pair.sections = rail;
    WheelOnRail lowered = pair;
    const TouchPoint touch = lower_to_touch(lowered).front();
    const CurvePoint at = pair.rail_at(touch.rail_s);
    const ContactRow row{at.s, at.position, at.delta};
    const SectionedRail::Direction direction = rail.direction(touch.x, row);
    const RailFrame next(frame.point_in_track(rail.point(touch.x, row)), direction.ahead);
    pair.sinking = direction.sinking;
    pair.surface_speed = next.along[0] + direction.sinking * next.along[2];
    const bool stays = i > 0 && norm(between(frame.along, next.along)) < same_direction &&
                       std::abs(next.origin[0] - frame.origin[0]) < same_origin;
    if (stays)
      return;
    frame = next;
  }
  pair.rail = rail.look_from(frame);
  pair.sections = rail;
}

} // namespace

CurvePoint WheelOnRail::rail_at(double s) const {
  CurvePoint p = rail.at(s);
  p.position = rail_pose.to_track(p.position);
  p.delta += rail_pose.angle;
  return p;
}

WheelFrame WheelOnRail::wheel_frame() const {
  return sections ? sections->frame().wheel(wheel_in_track()) : wheel_in_track();
}

WheelFrame WheelOnRail::wheel_in_track() const {
  const double cosine = std::cos(wheel_pose.angle), sine = std::sin(wheel_pose.angle);
  const Point2 centre = wheel_pose.to_track({0, -wheel_radius});
  const double arm = centre.y - centre_y;
  const Vector3 yawed{-std::sin(yaw) * arm, centre_y + std::cos(yaw) * arm, centre.z};
  const double c = std::cos(yaw + deviation.yaw), s = std::sin(yaw + deviation.yaw);
  return {yawed, {c, s, 0}, {-s * cosine, c * cosine, sine}, {s * sine, -c * sine, cosine}};
}

Vector3 WheelOnRail::wheelset_centre() const {
  const double roll = wheel_pose.angle - deviation.roll; // of the rigid wheelset
  const Point2 rigid =
      wheel_pose.to_track({0, -wheel_radius}) - Point2{deviation.lateral, deviation.vertical};
  const Vector3 centre{0, centre_y, rigid.z + (centre_y - rigid.y) * std::tan(roll)};
  return sections ? sections->frame().seen_point(centre) : centre;
}

WheelOnRail place(const WheelsetPosition& position, TabulatedProfile rail, TabulatedProfile wheel,
                  const std::shared_ptr<const RailSurfaces>& surface,
                  const std::shared_ptr<const SectionedSurface>& wheel_surface) {
  // Roll and yaw are axial vectors in the plane that mirrors left and right: they change sign with y.
  const double side = position.side == WheelSide::left ? -1 : 1;
  WheelOnRail pair{std::move(rail),
                   std::move(wheel),
                   {{0, 0}, -position.rail_inclination},
                   {{0, 0}, side * position.roll},
                   position.wheel_radius,
                   side * position.yaw,
                   side * position.lateral};

  if (position.uneven.given() || wheel_surface)
    pair.uneven = UnevenSurfaces(position.uneven, position.wheel_radius, wheel_surface);
  if (wheel_surface)
    pair.wheel = pair.uneven->wheel_sections()->section();
  require_axle_above(pair.wheel, position.wheel_radius);
  pair.rail_pose.origin = rail_origin(position, pair.rail, pair.rail_pose.angle) +
                          Point2{side * position.rail_lateral, position.rail_vertical};
  pair.rail_pose.angle += side * position.rail_roll;

  const Point2 by_flange{position.back_to_back / 2 + position.tape_circle, 0};
  const Point2 tape = position.wheel_origin.value_or(by_flange) + Point2{0, position.wheel_radius};
  pair.wheel_pose.origin =
      Point2{pair.centre_y, -position.wheel_radius} + turned(tape, pair.wheel_pose.angle);
  if (position.roller_radius != 0) {
    pair.roller = Roller{position.roller_radius + position.rail_vertical};
    require_axis_below(pair);
  }
  if (pair.uneven && pair.roller)
    throw InputError("An uneven wheel or rail does not stand on a roller",
                     "on a roller rig both are taken as round",
                     "Leave out wheel.flat, wheel.polygon, wheel.sections and rail.joint, or "
                     "rail.roller_radius.");
  const WheelDeviation& d = position.deviation;
  pair.deviation = {side * d.lateral, d.vertical, side * d.roll, side * d.yaw};
  const Point2 tape_radius{0, -position.wheel_radius};
  const Point2 centre = pair.wheel_pose.to_track(tape_radius) + Point2{pair.deviation.lateral, d.vertical};
  pair.wheel_pose.angle += pair.deviation.roll;
  if (d.roll != 0 || d.lateral != 0 || d.vertical != 0)
    pair.wheel_pose.origin = centre - turned(tape_radius, pair.wheel_pose.angle);
  if (!surface)
    return pair;
  const double along = position.uneven.along;
  const SectionedRail on_sections(surface, pair.rail_pose, along);
  try {
    look_from_touch(pair, on_sections);
  } catch (const InputError& error) {
    const auto [before, behind] = surface->places_about(along);
    throw InputError(
        fmt::format("At {:g} mm along the track, between the rail's sections at {:g} and {:g} mm: "
                    "{}",
                    along, before, behind, error.what()));
  }
  return pair;
}

} // namespace bem_contact
