#pragma once

#include "bem_contact/base/material.hpp"

#include <vector>

/// A sphere in a spherical seat: bodies of revolution about the normal, axisymmetric pressure, no friction.
namespace bem_contact::reference {

/// Displacement outward, mm, ~ P_n(cos theta), of the surface of a ball (radius R) and of a spherical cavity
/// in the full space under the pressure P_n(cos theta) of 1 MPa, without shear. n = 1 is refused: the
/// pressure has a resultant, and its displacement ~ cos(theta) is that of a rigid motion.
double ball_mode(const Material& material, double radius, int n);
double cavity_mode(const Material& material, double radius, int n);

/// Rings of equal area about the normal of a sphere, from the pole outwards: 1 - cos(theta) grows by `step`
/// from each border to the next.
struct EqualRings {
  double radius = 0; ///< mm
  double step = 0;   ///< of 1 - cos(theta)
  int count = 0;

  double area() const;           ///< of each, mm^2
  double cosine(int ring) const; ///< mean of cos(theta) over the ring's area
};

/// Influence numbers of the pair, the ball in the seat of (nearly) the same radius: the distance that opens
/// between the surfaces, mean over ring I's area, under 1 MPa on ring J. Shape [I][J], row-major, mm/MPa;
/// symmetric, for the rings have equal areas. Without the rigid mode n = 1: the approach is relative.
/// `modes`: Legendre polynomials; the error falls as its square once it exceeds pi over a ring's angle.
std::vector<double> ring_numbers(const Material& ball, const Material& seat, const EqualRings& rings,
                                 int modes);

} // namespace bem_contact::reference
