#pragma once

#include "bem_contact/base/material.hpp"

/// Friction: shift and rolling, closed forms and tables.
///
/// SIGNS. The literature (Carter, Kalker, Johnson) gives forces on the wheel; base/conventions.hpp has forces
/// on the RAIL. Everything below is in the project's signs: the force on the rail has the sign of the
/// creepage.
namespace bem_contact::reference {

/// Carter 1926: equal cylinders, plane strain, steady rolling. 1/R = 1/R1 + 1/R2.
struct CarterSolution {
  double normal_force = 0;     ///< Fn, N/mm
  double max_pressure = 0;     ///< p0, MPa
  double half_width = 0;       ///< a, mm
  double stick_half_width = 0; ///< a', mm; the stick zone ends at the leading edge x = a
  double friction = 0;
  double creepage = 0;    ///< xi > 0 for a force on the rail along +x (Johnson 1985, eq. 8.20)
  double force_ratio = 0; ///< Fx/(mu Fn) on the rail = 1 - (a'/a)^2 (Johnson 1985, eq. 8.21)

  /// Traction on the rail, MPa (Johnson 1985, eq. 8.17).
  double traction(double x) const;
};
/// Both bodies of one material; 0 <= a' <= a.
CarterSolution carter(const Material& material, double radius, double half_width, double stick_half_width,
                      double friction);

/// Cattaneo 1938, Mindlin 1949: equal spheres pressed together, then shifted by a tangential force below
/// mu N (Johnson 1985, section 7.2d).
struct CattaneoSolution {
  double stick_ratio = 0; ///< theta = stick radius / a, theta^3 = 1 - F/(mu N)
  double shift = 0;       ///< relative tangential displacement of distant points, mm
};
/// Throws InputError where force exceeds mu N.
CattaneoSolution cattaneo(const Material& material, double radius, double normal_force, double friction,
                          double tangential_force);

/// Combined constants of unlike bodies (Kalker 1990, eq. 1.44): 1/G, nu/G their means and
/// K/G = ((1 - 2 nu1)/G1 - (1 - 2 nu2)/G2)/4.
struct CombinedMaterial {
  double shear_modulus = 0, poisson = 0, difference = 0; ///< G, nu, K
};
CombinedMaterial combined(const Material& one, const Material& other);

/// Bentall and Johnson 1967: creepage of freely rolling unlike cylinders, frictionless limit,
/// 0.4574 kappa a/R (printed: 0.457), kappa = 2K/(1 - nu), 1/R = 1/R1 + 1/R2. Its sign is that of K (body 1
/// the more compliant).
double bentall_johnson_creepage(const Material& one, const Material& other, double radius, double half_width);

/// |Mz| of a circular Hertzian contact of radius a that slips everywhere in pure spin: (3 pi/16) mu N a.
double full_spin_moment(double friction, double normal_force, double radius);

} // namespace bem_contact::reference
