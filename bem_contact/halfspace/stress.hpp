#pragma once

#include <array>

namespace bem_contact::halfspace {

/// Symmetric stress tensor in the frame (x, s, n), n into the body; MPa, tension positive.
struct Stress {
  double xx = 0, ss = 0, nn = 0, xs = 0, xn = 0, sn = 0; ///< MPa

  /// Adds a multiple of another.
  Stress& add(double weight, const Stress& other);
  bool operator==(const Stress&) const = default;
};

/// Von Mises' equivalent stress, MPa.
double von_mises(const Stress& stress);
/// Largest shear stress, half the difference of the outer principal stresses, MPa.
double largest_shear(const Stress& stress);

/// Stress at the point (x, s, n), n > 0, in the half-space n > 0 under unit uniform traction on the rectangle
/// 2a x 2b about the origin: [j] for traction j = x, s, n that acts on the body (n: pressure), per MPa. Of
/// the material only Poisson's ratio counts. From the potentials of Boussinesq and Cerruti (Love 1929;
/// Johnson 1985, section 3.2; Kalker 1990, section 4) integrated in closed form. Throws InputError unless n >
/// 0.
std::array<Stress, 3> rectangle_stress(double poisson, double x, double s, double n, double a, double b);

} // namespace bem_contact::halfspace
