#pragma once

#include "bem_contact/base/material.hpp"

/// Frictionless contact of half-spaces, closed forms. All functions throw InputError for arguments that are
/// not finite or not positive.
namespace bem_contact::reference {

/// E* of a pair: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, MPa (Johnson 1985, eq. 4.20).
double contact_modulus(const Material& one, const Material& other);

/// An elliptical contact. The semi-axes lie along x and s as the curvatures A and B do.
struct HertzContact {
  double force = 0;        ///< N
  double approach = 0;     ///< mm
  double semi_axis_x = 0;  ///< mm
  double semi_axis_s = 0;  ///< mm
  double max_pressure = 0; ///< p0, MPa; p = p0 sqrt(1 - (x/a)^2 - (s/b)^2)
};

/// Undeformed distance A x^2 + B s^2, A, B > 0 in 1/mm (Hertz 1882; Johnson 1985, eqs 4.25 to 4.32).
HertzContact hertz_by_force(double curvature_x, double curvature_s, double modulus, double force);
HertzContact hertz_by_approach(double curvature_x, double curvature_s, double modulus, double approach);

/// A / B of the undeformed distance whose ellipse has that ratio of semi-axes along x and s (Johnson 1985,
/// eq. 4.28).
double hertz_curvature_ratio(double x_over_s);

/// By how much the pressure of `contact` lowers both surfaces together at (x, s) from its middle, mm, inside
/// the ellipse and outside: the integral of Johnson 1985, eqs 3.36 and 3.41, in elliptic integrals. Inside it
/// is approach - A x^2 - B s^2.
double hertz_compression(const HertzContact& contact, double modulus, double x, double s);

} // namespace bem_contact::reference
