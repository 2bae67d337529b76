#pragma once

#include "bem_contact/contact/problem.hpp"
#include "bem_contact/wheelset/placement.hpp"

namespace bem_contact {

/// Creepages at the reference point; the spin that comes from the geometry is added by rigid_slip().
struct Creepage {
  double xi = 0, eta = 0;    ///< longitudinal, lateral (along the rail's tangent there)
  double phi = 0;            ///< about the rail's normal there, 1/mm
  double rolling_radius = 0; ///< R_roll at xi = 0, mm; 0: the wheel's radius at the reference point
};

/// Rigid slip w = velocity of the wheel's surface over the rail's, over the rolling speed V, in the local
/// frames of the rows; fields slip_x, slip_s of `problem` (grid and rows set). The reference point lies at
/// x = 0 on the rail (position, delta: track frame).
///
/// The wheel rolls towards +x; z is down, so it turns by omega = -V/R_roll about the axle's +y direction and
/// with (x, r) from the axle, r along the radius through the contact, its surface moves by
///   v/V = (1 - r/R_roll) e_x + (x/R_roll) e_r,   R_roll such that v_x/V = xi at radius `rolling_radius`,
/// plus eta along the rail's tangent and phi about the rail's normal at the reference point. Projected on
/// frames at inclination delta this is w_x = xi - sin(delta)/R s, w_s = eta + sin(delta)/R x to first order:
/// the geometric spin is phi = sin(delta)/R, negative at the gauge corner of a right-hand rail.
void set_rigid_slip(ContactProblem& problem, const WheelOnRail& pair, Point2 reference,
                    double reference_delta, const Creepage& creepage);

/// A shift of the wheel that does not turn, on the same frames, mm: w_x = xi - phi s, w_s = (eta + phi x)
/// cos(delta - reference_delta), xi, eta in mm and phi in rad, s along the tangent at the reference point.
void set_rigid_shift(ContactProblem& problem, Point2 reference, double reference_delta,
                     const Creepage& creepage);

/// The same as set_rigid_slip for a patch given directly: w_x = xi - phi s, w_s = eta + phi x (s measured
/// from the grid's middle, x from `x_of_contact`).
void set_rigid_slip(ContactProblem& problem, const Creepage& creepage, double x_of_contact = 0);

} // namespace bem_contact
