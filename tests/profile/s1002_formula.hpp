#pragma once

#include <cmath>

namespace bem_contact {

/// z(y) of S1002 by the formulas of EN 13715 (also UIC 510-2) as they stand there, -70 <= y <= 60; at a joint
/// the zone on the field side. Extended precision, because zone C cancels four digits.
inline double s1002_height(double at) {
  const long double y = at;
  const auto power = [y](int n) { return std::pow(y, n); };
  const auto circle = [y](long double z, int sign, long double radius, long double centre) {
    return z + sign * std::sqrt(radius * radius - (y + centre) * (y + centre));
  };
  const auto height = [&] {
    if (y >= 32.15796L) // A
      return 1.364323640L - 0.066666667L * y;
    if (y >= -26) // B
      return -3.358537058e-2L * y + 1.565681624e-3L * power(2) - 2.810427944e-5L * power(3) +
             5.844240864e-8L * power(4) - 1.562379023e-8L * power(5) + 5.309217349e-15L * power(6) -
             5.957839843e-12L * power(7) + 2.646656573e-13L * power(8);
    if (y >= -35) // C
      return -4.320221063e3L - 1.038384026e3L * y - 1.065501873e2L * power(2) - 6.051367875L * power(3) -
             2.054332446e-1L * power(4) - 4.169739389e-3L * power(5) - 4.687195829e-5L * power(6) -
             2.252755540e-7L * power(7);
    if (y >= -38.426669071L) // D
      return circle(16.446L, -1, 13, 26.210665L);
    if (y >= -39.764473993L) // E
      return -93.576667419L - 2.747477419L * y;
    if (y >= -49.662510381L) // F
      return circle(8.834924130L, 1, 20, 58.558326413L);
    if (y >= -62.764705882L) // G
      return circle(16, 1, 12, 55);
    return circle(9.519259302L, 1, 20.5L, 49.5L); // H
  };
  return static_cast<double>(height());
}

} // namespace bem_contact
