#include "bem_contact/wheelset/rigid_slip.hpp"

namespace bem_contact {

void set_rigid_slip(ContactProblem& problem, const WheelOnRail& pair, Point2 reference,
                    double reference_delta, const Creepage& creepage) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  const Point2 radial = normal_of(pair.wheel_pose.angle); // from the axle down through the wheel
  const double radius =
      creepage.rolling_radius > 0 ? creepage.rolling_radius : dot(reference - pair.axle(), radial);
  const double turning = (1 - creepage.xi) / radius; // 1 / R_roll
  const Point2 tangent = tangent_of(reference_delta);
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const Point2 along = tangent_of(row.delta);
    const double r = dot(row.position - pair.axle(), radial);
    const double s = dot(row.position - reference, tangent);
    for (int ix = 0; ix < grid.mx; ++ix) {
      const double x = grid.x(ix);
      // phi e_n x (r - reference), with e_n x e_x = e_s and e_n x e_s = -e_x at the reference point.
      const Point2 lateral = x * turning * radial + (creepage.eta + creepage.phi * x) * tangent;
      problem.slip_x[is * grid.mx + ix] = 1 - r * turning - creepage.phi * s;
      problem.slip_s[is * grid.mx + ix] = dot(lateral, along);
    }
  }
}

void set_rigid_shift(ContactProblem& problem, Point2 reference, double reference_delta,
                     const Creepage& creepage) {
  const ContactGrid& grid = problem.grid;
  problem.slip_x.resize(grid.size());
  problem.slip_s.resize(grid.size());
  for (int is = 0; is < grid.ms; ++is) {
    const ContactRow& row = problem.rows[is];
    const double s = dot(row.position - reference, tangent_of(reference_delta));
    const double share = std::cos(row.delta - reference_delta);
    for (int ix = 0; ix < grid.mx; ++ix) {
      problem.slip_x[is * grid.mx + ix] = creepage.xi - creepage.phi * s;
      problem.slip_s[is * grid.mx + ix] = (creepage.eta + creepage.phi * grid.x(ix)) * share;
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
