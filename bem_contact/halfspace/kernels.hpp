#pragma once

#include "bem_contact/halfspace/rectangle.hpp"

/// Private to this room: what a single element and a line of elements share.
namespace bem_contact::halfspace {

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

  Kernels& add(double weight, const Kernels& k) {
    xx_r3 += weight * k.xx_r3;
    ss_r3 += weight * k.ss_r3;
    xs_r3 += weight * k.xs_r3;
    x_r2 += weight * k.x_r2;
    s_r2 += weight * k.s_r2;
    return *this;
  }
};

/// Influence number of one body from the kernels (Boussinesq-Cerruti; Kalker 1990, appendix E).
Matrix3 assemble(const Material& material, const Kernels& k);

/// Throws InputError unless `value` is a positive length.
void require_size(double value, const char* name);

} // namespace bem_contact::halfspace
