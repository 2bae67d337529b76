#include "bem_contact/geometry/rigid_slip.hpp"

namespace bem_contact {

namespace {

/// `of(row, x)`: w_x and w_s of one element.
template <class Of>
RigidSlip fields(std::span<const ContactRow> rows, std::span<const double> x, const Of& of) {
  RigidSlip slip;
  slip.x.reserve(rows.size() * x.size());
  slip.s.reserve(rows.size() * x.size());
  for (const ContactRow& row : rows)
    for (const double at : x) {
      const auto [w_x, w_s] = of(row, at);
      slip.x.push_back(w_x);
      slip.s.push_back(w_s);
    }
  return slip;
}

/// How fast both surfaces move at the reference point, over V, and over the mean of both.
struct SurfaceSpeeds {
  double radius = 0;            ///< of the wheel there, mm
  double roller_radius = 0;     ///< of the roller there, mm
  double wheel = 1, roller = 1; ///< over V
  double mean() const { return 0.5 * (wheel + roller); }
};

/// The creepage of surfaces of these speeds.
double over_mean(double roller, double wheel) {
  return (roller - wheel) / (0.5 * (roller + wheel));
}

SurfaceSpeeds speeds_of(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage) {
  SurfaceSpeeds out{radius_at(pair, reference.x, reference.position),
                    pair.roller->radius(reference.position)};
  if (creepage.rolling_radius > 0)
    out.wheel = out.radius / creepage.rolling_radius;
  if (creepage.roller_speed > 0)
    out.roller = creepage.roller_speed * out.roller_radius;
  return out;
}

/// What the wheel does, over V: its turning about its axle, and all else that moves it.
class WheelMotion {
public:
  WheelMotion(const WheelOnRail& pair, const Creepage& creepage)
      : frame_(pair.wheel_frame()), centre_(pair.wheelset_centre()), velocity_(pair.seen(creepage.velocity)),
        own_(creepage.wheel_velocity != Vector3{} || creepage.wheel_rates != Vector3{}) {
    const WheelFrame track = pair.wheel_in_track();
    rotation_ = pair.seen({creepage.roll * track.forward[0], creepage.roll * track.forward[1], creepage.yaw});
    if (!own_)
      return;
    const double c = std::cos(pair.yaw), s = std::sin(pair.yaw);
    const auto& [forward, right, down] = creepage.wheel_velocity;
    own_velocity_ = pair.seen({c * forward - s * right, s * forward + c * right, down});
    const auto& [roll, pitch, yaw] = creepage.wheel_rates;
    for (int i = 0; i < 3; ++i)
      own_rotation_[i] = roll * track.forward[i] - pitch * track.axle[i] + (i == 2 ? yaw : 0.0);
    own_rotation_ = pair.seen(own_rotation_);
  }

  /// The velocity of a point of the wheel that turns by `turning` per rolled distance, rad/mm.
  Vector3 at(const Vector3& p, double turning) const {
    const Vector3 turned = cross(frame_.axle, between(frame_.centre, p)),
                  rotated = cross(rotation_, between(centre_, p));
    Vector3 out;
    for (int i = 0; i < 3; ++i)
      out[i] = velocity_[i] + rotated[i] - turning * turned[i];
    if (!own_)
      return out;
    const Vector3 own = cross(own_rotation_, between(frame_.centre, p));
    for (int i = 0; i < 3; ++i)
      out[i] += own_velocity_[i] + own[i];
    return out;
  }

private:
  WheelFrame frame_;
  Vector3 centre_, velocity_, rotation_{};
  bool own_;
  Vector3 own_velocity_{}, own_rotation_{};
};

/// Adds eta along the tangent and phi about the normal at the reference point to a velocity, and takes what
/// lies in the row's plane: phi e_n x (r - reference), with e_n x e_x = e_s and e_n x e_s = -e_x at the
/// reference point.
struct AddedCreepage {
  const ReferencePoint& reference;
  const Creepage& creepage;
  Point2 tangent = tangent_of(reference.delta);

  std::pair<double, double> on(const ContactRow& row, double x, const Vector3& v) const {
    const double s = dot(row.position - reference.position, tangent);
    const Point2 added = (creepage.eta + creepage.phi * (x - reference.x)) * tangent;
    return {v[0] - creepage.phi * s + creepage.slip_x,
            dot(added + Point2{v[1], v[2]}, tangent_of(row.delta))};
  }
};

RigidSlip slip_on_roller(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage,
                         std::span<const ContactRow> rows, std::span<const double> x) {
  const SurfaceSpeeds speeds = speeds_of(pair, reference, creepage);
  const double mean = speeds.mean();
  const double xi = over_mean(speeds.roller, speeds.wheel) + creepage.xi * speeds.wheel;
  const double turning = (1 - 0.5 * xi) / speeds.radius, rolling = (1 + 0.5 * xi) / speeds.roller_radius;
  const WheelMotion wheel(pair, creepage);
  const AddedCreepage added{reference, creepage};
  return fields(rows, x, [&](const ContactRow& row, double at) {
    const Vector3 in_space = wheel.at(pair.roller->in_space(at, row.position), turning * mean);
    Vector3 v = Roller::seen(in_space, pair.roller->angle(at, row.position));
    for (double& component : v)
      component /= mean;
    v[0] += rolling * pair.roller->radius(row.position);
    return added.on(row, at, v);
  });
}

} // namespace

double radius_at(const WheelFrame& frame, const Vector3& point) {
  return cross(frame.axle, between(frame.centre, point))[0];
}

double radius_at(const WheelOnRail& pair, const WheelFrame& frame, double x, Point2 point) {
  if (!pair.roller)
    return radius_at(frame, {x, point.y, point.z + pair.rail_lower(x)}) / pair.surface_speed;
  const Vector3 turned = cross(frame.axle, between(frame.centre, pair.roller->in_space(x, point)));
  return Roller::seen(turned, pair.roller->angle(x, point))[0];
}

double radius_at(const WheelOnRail& pair, double x, Point2 point) {
  return radius_at(pair, pair.wheel_frame(), x, point);
}

RollingSpeed rolling_speed(const WheelOnRail& pair, const ReferencePoint& reference,
                           const Creepage& creepage) {
  const double radius = creepage.rolling_radius > 0 ? creepage.rolling_radius
                                                    : radius_at(pair, reference.x, reference.position);
  if (!pair.roller)
    return {.radius = radius};
  const SurfaceSpeeds speeds = speeds_of(pair, reference, creepage);
  return {radius, speeds.wheel, speeds.roller, true};
}

double RollingSpeed::radius_at(double xi) const {
  if (!on_roller)
    return radius / (1 - xi);
  const double half = 0.5 * (over_mean(roller, wheel) + xi * wheel);
  return radius * wheel * (1 + half) / (roller * (1 - half));
}

double RollingSpeed::xi_at(double other) const {
  if (!on_roller)
    return 1 - radius / other;
  return (over_mean(roller, wheel * radius / other) - over_mean(roller, wheel)) / wheel;
}

double mean_surface_speed(const WheelOnRail& pair, const ReferencePoint& reference,
                          const Creepage& creepage) {
  return pair.roller ? speeds_of(pair, reference, creepage).mean() : pair.surface_speed;
}

RigidSlip rigid_slip(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage,
                     std::span<const ContactRow> rows, std::span<const double> x) {
  if (pair.roller)
    return slip_on_roller(pair, reference, creepage, rows, x);
  const double radius = creepage.rolling_radius > 0 ? creepage.rolling_radius
                                                    : radius_at(pair, reference.x, reference.position);
  const double turning = (1 - creepage.xi) / radius; // 1 / R_roll
  const WheelMotion wheel(pair, creepage);
  const AddedCreepage added{reference, creepage};
  double sinking = pair.sinking;
  if (pair.uneven) {
    const Vector3 v = cross(pair.wheel_frame().axle, {reference.ahead, 0, 0}); // over -turning
    sinking = turning * dot(Point2{v[1], v[2]}, normal_of(reference.delta)) / std::cos(reference.delta);
  }
  const Vector3 travel = pair.seen({1, 0, sinking});
  return fields(rows, x, [&](const ContactRow& row, double at) {
    Vector3 v = wheel.at(pair.in_space(at, row), turning);
    for (int i = 0; i < 3; ++i)
      v[i] = (v[i] + travel[i]) / pair.surface_speed;
    return added.on(row, at, v);
  });
}

RigidSlip rigid_shift(const ReferencePoint& reference, const Creepage& creepage,
                      std::span<const ContactRow> rows, std::span<const double> x) {
  return fields(rows, x, [&](const ContactRow& row, double at) {
    const double s = dot(row.position - reference.position, tangent_of(reference.delta));
    return std::pair(creepage.xi - creepage.phi * s, (creepage.eta + creepage.phi * (at - reference.x)) *
                                                         std::cos(row.delta - reference.delta));
  });
}

RigidSlip planar_slip(const Creepage& creepage, std::span<const ContactRow> rows, std::span<const double> x,
                      double x_of_contact) {
  return fields(rows, x, [&](const ContactRow& row, double at) {
    return std::pair(creepage.xi - creepage.phi * row.s, creepage.eta + creepage.phi * (at - x_of_contact));
  });
}

} // namespace bem_contact
