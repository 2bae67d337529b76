#pragma once

#include <array>

/// Kalker's creep coefficients.
namespace bem_contact::reference {

/// These coefficients make the forces, with c = sqrt(ab) and the project's signs (forces on the rail):
///     Fx = c^2 G c11 xi,  Fy = c^2 G (c22 eta + c c23 phi),  Mz = c^3 G (-c23 eta + c c33 phi).
struct CreepCoefficients {
  double a_over_b = 1; ///< semi-axis along x over semi-axis along s
  double poisson = 0;
  double c11 = 0, c22 = 0, c23 = 0, c33 = 0;
};

/// Coefficients of the linear theory (no slip anywhere; Kalker 1967; table E3 of Kalker 1990) for equal
/// materials. The tractions are polynomials of `degree` over the square root of the ellipse. At degree 12 the
/// coefficients are within 1e-4 for a/b of 0.3 to 3 and within 3e-3 at 0.1 and 10. On a circle with nu = 0
/// they are 32/(3 pi), 32/(3 pi), 4/3 and 512/(135 pi) to 1e-7. Throws InputError unless a/b is 0.1 to 10, nu
/// 0 to 0.5 and the degree 2 to 20.
CreepCoefficients creep_coefficients(double a_over_b, double poisson, int degree = 12);

/// C11, C22 and C23 of creep_coefficients() within 5e-4, in a microsecond: their logarithms as Chebyshev
/// polynomials of log10 a/b and nu. Throws InputError unless a/b is 0.1 to 10 and nu 0 to 0.5.
std::array<double, 3> quick_creep_coefficients(double a_over_b, double poisson);

} // namespace bem_contact::reference
