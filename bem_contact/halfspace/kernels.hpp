#pragma once

#include "bem_contact/base/conventions.hpp"
#include "bem_contact/base/material.hpp"

#include <array>

/// What the room's closed forms share.
namespace bem_contact::halfspace {

/// 3 x 3, row i = displacement, column j = traction, mm/MPa.
using Matrix3 = std::array<std::array<double, 3>, 3>;

// The closed forms are differences of large numbers; extended precision keeps elements of a large aspect
// ratio exact where double would lose (r^2 / (4 a b))^2 digits.
using Real = long double;

/// The five basic kernels of Boussinesq-Cerruti, point-wise or integrated.
struct Kernels {
  double xx_r3 = 0; ///< x^2 / r^3
  double ss_r3 = 0; ///< s^2 / r^3
  double xs_r3 = 0; ///< x s / r^3
  double x_r2 = 0;  ///< x / r^2
  double s_r2 = 0;  ///< s / r^2
};

/// Influence number of one body from the kernels (Boussinesq-Cerruti; Kalker 1990, appendix E).
Matrix3 assemble(const Material& material, const Kernels& k);

/// Throws InputError unless `value` is a positive length.
void require_size(double value, const char* name);

} // namespace bem_contact::halfspace
