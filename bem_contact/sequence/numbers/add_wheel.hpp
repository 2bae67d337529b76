#pragma once

#include "bem_contact/influence/influence_numbers.hpp"

#include <span>

namespace bem_contact {

/// Adds a wheel's numbers of one row to the numbers of its rail, which become those of the pair in the
/// contact frame (halfspace::combine()): no table of the wheel's own is needed. `wheel`: in its own frame,
/// rows in the contact's order; it is changed. Several threads may add different rows.
///
/// Where `inclination` is not empty, the wheel's numbers have first what its radial displacement does to
/// steady rolling. A point of the wheel's surface that has moved away from the axle by u_r is faster by the
/// share u_r / R, so the slip over the rolling speed is
///     S / dx = w - du_x/dx - u_r / R = w - d/dx (u_x + 1/R int u_r dx).
/// The integral is linear in the tractions, and in x it is as regular as u_x: with it in A_x the solver and
/// the certificate need not know of it. Kalker's half-space leaves u_r / R out. It is a uniform slip in the
/// main, and so drops out from creep forces that are counted from free rolling.
///
/// `inclination`: of each row against the wheel's axle, rad. `radius`: R, mm. The integral over x is by the
/// trapezoidal rule, zero at the loaded element; parity in x stays. Only A_xj change, so that they are no
/// longer reciprocal.
void add_wheel(NumberLines& wheel, std::span<const double> inclination, double radius,
               InfluenceNumbers& pair);

/// Adds to a roller's own numbers what its radial displacement does to steady rolling, as add_wheel() does
/// for the wheel. `inclination`: of each row against the roller's axis, rad. `radius`: of the roller, mm.
void add_radial_displacement(std::span<const double> inclination, double radius, InfluenceNumbers& roller);

} // namespace bem_contact
