#include "bem_contact/geometry/rigid_slip.hpp"

namespace bem_contact {

namespace {

Vector3 cross(const Vector3& a, const Vector3& r) {
  return {a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
}

Vector3 from(const Vector3& centre, double x, Point2 p) {
  return {x - centre[0], p.y - centre[1], p.z - centre[2]};
}

} // namespace

void set_rigid_slip(ContactProblem& problem, const WheelOnRail& pair, const ReferencePoint& reference,
                    const Creepage& creepage) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  const WheelFrame frame = pair.wheel_frame();
  // The vertical about which the wheelset is yawed meets its axle at x = 0.
  const double arm = (pair.centre_y - frame.centre[1]) / frame.axle[1];
  const Vector3 centre{0, pair.centre_y, frame.centre[2] + arm * frame.axle[2]};
  const Vector3 rotation{creepage.roll * frame.forward[0], creepage.roll * frame.forward[1], creepage.yaw};
  const auto around_axle = [&](double x, Point2 p) { return cross(frame.axle, from(frame.centre, x, p)); };
  const double radius =
      creepage.rolling_radius > 0 ? creepage.rolling_radius : around_axle(reference.x, reference.position)[0];
  const double turning = (1 - creepage.xi) / radius; // 1 / R_roll
  const Point2 tangent = tangent_of(reference.delta);
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const Point2 along = tangent_of(row.delta);
    const double s = dot(row.position - reference.position, tangent);
    for (int ix = 0; ix < grid.mx; ++ix) {
      const double x = grid.x(ix);
      const Vector3 turned = around_axle(x, row.position);
      // phi e_n x (r - reference), with e_n x e_x = e_s and e_n x e_s = -e_x at the reference point.
      const Point2 added = (creepage.eta + creepage.phi * (x - reference.x)) * tangent;
      const Vector3 rotated = cross(rotation, from(centre, x, row.position));
      const auto own = [&](int k) { return creepage.velocity[k] + rotated[k] - turning * turned[k]; };
      problem.slip_x[is * grid.mx + ix] = 1 + own(0) - creepage.phi * s;
      problem.slip_s[is * grid.mx + ix] = dot(added + Point2{own(1), own(2)}, along);
    }
  }
}

void set_rigid_shift(ContactProblem& problem, const ReferencePoint& reference, const Creepage& creepage) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const double s = dot(row.position - reference.position, tangent_of(reference.delta));
    const double share = std::cos(row.delta - reference.delta);
    for (int ix = 0; ix < grid.mx; ++ix) {
      problem.slip_x[is * grid.mx + ix] = creepage.xi - creepage.phi * s;
      problem.slip_s[is * grid.mx + ix] = (creepage.eta + creepage.phi * (grid.x(ix) - reference.x)) * share;
    }
  }
}

void set_rigid_slip(ContactProblem& problem, const Creepage& creepage, double x_of_contact) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  for (int is = 0; is < grid.ms; ++is) {
    for (int ix = 0; ix < grid.mx; ++ix) {
      problem.slip_x[is * grid.mx + ix] = creepage.xi - creepage.phi * problem.rows[is].s;
      problem.slip_s[is * grid.mx + ix] = creepage.eta + creepage.phi * (grid.x(ix) - x_of_contact);
    }
  }
}

} // namespace bem_contact
