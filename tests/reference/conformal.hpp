#pragma once

#include "bem_contact/base/material.hpp"

#include <array>
#include <span>

/// Conformal contact, closed forms: a disc (radius R) in a hole (radius R + dR), and a sphere in a seat.
namespace bem_contact::reference {

/// E1* = E/(1 - nu^2) = 2G/(1 - nu), MPa: twice the contact modulus of a pair of equal bodies.
double plane_strain_modulus(const Material& material);

/// Persson 1964 ("On the stress distribution of cylindrical elastic bodies in contact", thesis, Chalmers):
/// identical materials, plane strain, frictionless. Half angle eps of the contact, rad, in (0, pi).
/// Returns E1* dR/Q, Q the force per length: above 0 for clearance, 0 at 84.828 degrees (perfect fit).
double persson_clearance(double half_angle);
/// The half angle for a given E1* dR/Q >= 0.
double persson_half_angle(double clearance);
/// p(phi) R/Q at the angle phi from the middle; 0 outside the contact.
double persson_pressure(double half_angle, double phi);

/// Michell 1899: tractions p_n cos(n th) (pressure) and q_n sin(n th) (shear) on disc and hole of radius R,
/// identical materials, plane strain. Displacement difference hole - disc, radial ~ cos(n th) and
/// circumferential ~ sin(n th): [du_r, du_th] = C [p_n, q_n], mm/MPa. n >= 2; n = 0 has du_r alone; n = 1 is
/// a rigid motion and refused.
std::array<std::array<double, 2>, 2> michell_pair(const Material& material, double radius, int n);

/// One body alone under a normal load p_n cos(n th), n >= 2: displacement away from the centre ~ cos(n th)
/// and circumferential ~ sin(n th), mm/MPa.
struct RadialDisplacement {
  double radial = 0, circumferential = 0;
};
RadialDisplacement michell_disc(const Material& material, double radius, int n);
RadialDisplacement michell_hole(const Material& material, double radius, int n);

/// The pair under a normal line load P (N/mm) at th = 0: difference at th (not 0), modulo rigid motions.
/// Without any, the radial one is negative from 41.88 to 117.7 degrees.
RadialDisplacement michell_line_load(const Material& material, double load, double theta);

/// Sphere of radius R in a spherical seat R + dR, identical materials, nu = 0.3, frictionless (recomputed
/// table).
struct SeatEntry {
  double half_angle = 0;     ///< degrees
  double force = 0;          ///< Q/(E dR R)
  double pressure = 0;       ///< p(0) R^2/Q
  double pressure_ratio = 0; ///< p(0)/p_Hertz(Q)
};
std::span<const SeatEntry> sphere_in_seat();

} // namespace bem_contact::reference
