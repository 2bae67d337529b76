#include "bem_contact/wheelset/rigid_slip.hpp"

namespace bem_contact {

void set_rigid_slip(ContactProblem& problem, const WheelOnRail& pair, const ReferencePoint& reference,
                    const Creepage& creepage) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  const WheelFrame frame = pair.wheel_frame();
  // a x (X - C)
  const auto around_axle = [&](double x, Point2 p) {
    const Vector3 r{x - frame.centre[0], p.y - frame.centre[1], p.z - frame.centre[2]};
    const Vector3& a = frame.axle;
    return Vector3{a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
  };
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
      problem.slip_x[is * grid.mx + ix] = 1 - turning * turned[0] - creepage.phi * s;
      problem.slip_s[is * grid.mx + ix] = dot(added - turning * Point2{turned[1], turned[2]}, along);
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
