#include "bem_contact/uses/fatigue/shakedown.hpp"

#include "bem_contact/uses/fatigue/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::fatigue {

namespace {

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
