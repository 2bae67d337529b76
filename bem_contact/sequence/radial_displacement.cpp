#include "bem_contact/sequence/radial_displacement.hpp"

#include <cmath>
#include <vector>

namespace bem_contact {

void add_radial_displacement(std::span<const double> inclination, double radius, InfluenceNumbers& wheel) {
  const double half_step = 0.5 * wheel.dx / radius;
  const std::size_t rows = wheel.rows, size = 3 * rows;
  std::vector<double> sum(rows * size, 0.0), last = sum; // [I][J][j]
  for (int m = 0; m < wheel.offsets; ++m)                // in the order of memory
    for (std::size_t row = 0; row < rows; ++row) {
      // The wheel's own frame is the contact frame turned by pi about x (base/conventions.hpp).
      const double along_s = -std::sin(inclination[row]), along_n = -std::cos(inclination[row]);
      double* const block = &wheel.values[(m * rows + row) * 3 * size];
      const double *of_s = block + component_s * size, *of_n = block + component_n * size;
      double *to = block + component_x * size, *so_far = &sum[row * size], *before = &last[row * size];
      for (std::size_t at = 0; at < size; ++at) {
        const double here = along_s * of_s[at] + along_n * of_n[at];
        so_far[at] += m > 0 ? half_step * (before[at] + here) : 0.0;
        before[at] = here;
        to[at] += so_far[at];
      }
    }
}

} // namespace bem_contact
