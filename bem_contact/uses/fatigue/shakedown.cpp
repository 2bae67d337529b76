#include "bem_contact/uses/fatigue/shakedown.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::fatigue {

namespace {

/// 1 (half width of a long contact). Where limit_below() looks for the largest shear: it lies between the
/// edges, and at most 0.5 deep.
constexpr double shakedown_extent = 1.5;
/// 1. Step of that search: with a tenth of it limits fall by less than 1e-4 of themselves.
constexpr double shakedown_step = 0.01;

/// The shear along the surface over p0; x and z (down) over the half width of the contact.
double shear_of_line(double x, double z, double traction) {
  const double sum = 1 - x * x + z * z, size = std::hypot(sum, 2 * x * z);
  const double m = std::sqrt((size + sum) / 2),
               n = std::copysign(std::sqrt(std::max(size - sum, 0.0) / 2), x);
  const double square = std::max(m * m + n * n, 1e-12); // 0 at the edges of the contact
  const double pressed = -n * (m * m - z * z) / square, along = -(m * (1 + (z * z + n * n) / square) - 2 * z);
  return pressed + traction * along;
}

} // namespace

double limit_below(double traction) {
  double largest = std::abs(traction); // on the surface
  const int half = static_cast<int>(std::lround(shakedown_extent / shakedown_step));
  for (int j = 0; j <= half; ++j)
    for (int i = -half; i <= half; ++i)
      largest = std::max(largest, std::abs(shear_of_line(i * shakedown_step, j * shakedown_step, traction)));
  return 1 / largest;
}

} // namespace bem_contact::fatigue
