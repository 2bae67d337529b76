#include "bem_contact/geometry/rigid_slip.hpp"

namespace bem_contact {

namespace {

Vector3 cross(const Vector3& a, const Vector3& r) {
  return {a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
}

Vector3 from(const Vector3& centre, double x, Point2 p) {
  return {x - centre[0], p.y - centre[1], p.z - centre[2]};
}

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

} // namespace

double radius_at(const WheelOnRail& pair, double x, Point2 point) {
  const WheelFrame frame = pair.wheel_frame();
  return cross(frame.axle, from(frame.centre, x, point))[0];
}

RigidSlip rigid_slip(const WheelOnRail& pair, const ReferencePoint& reference, const Creepage& creepage,
                     std::span<const ContactRow> rows, std::span<const double> x) {
  const WheelFrame frame = pair.wheel_frame();
  // The vertical about which the wheelset is yawed meets its axle at x = 0.
  const double arm = (pair.centre_y - frame.centre[1]) / frame.axle[1];
  const Vector3 centre{0, pair.centre_y, frame.centre[2] + arm * frame.axle[2]};
  const Vector3 rotation{creepage.roll * frame.forward[0], creepage.roll * frame.forward[1], creepage.yaw};
  const auto around_axle = [&](double at, Point2 p) { return cross(frame.axle, from(frame.centre, at, p)); };
  const double radius = creepage.rolling_radius > 0 ? creepage.rolling_radius
                                                    : radius_at(pair, reference.x, reference.position);
  const double turning = (1 - creepage.xi) / radius; // 1 / R_roll
  const Point2 tangent = tangent_of(reference.delta);
  return fields(rows, x, [&](const ContactRow& row, double at) {
    const double s = dot(row.position - reference.position, tangent);
    const Vector3 turned = around_axle(at, row.position);
    // phi e_n x (r - reference), with e_n x e_x = e_s and e_n x e_s = -e_x at the reference point.
    const Point2 added = (creepage.eta + creepage.phi * (at - reference.x)) * tangent;
    const Vector3 rotated = cross(rotation, from(centre, at, row.position));
    const auto own = [&](int k) { return creepage.velocity[k] + rotated[k] - turning * turned[k]; };
    return std::pair(1 + own(0) - creepage.phi * s + creepage.slip_x,
                     dot(added + Point2{own(1), own(2)}, tangent_of(row.delta)));
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
