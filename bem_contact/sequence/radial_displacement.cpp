#include "bem_contact/sequence/radial_displacement.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace bem_contact {

void add_radial_displacement(const InfluenceNumbers& wheel, std::span<const double> inclination,
                             double radius, InfluenceNumbers& pair) {
  // The wheel's own frame is the contact frame turned by pi about x (base/conventions.hpp).
  constexpr std::array<double, 3> turned{1, -1, -1};
  const double half_step = 0.5 * wheel.dx / radius;
  const std::size_t rows = pair.rows, size = 3 * rows;
  std::vector<double> sum(rows * size, 0.0), last = sum; // [I][J][j]
  for (int m = 0; m < pair.offsets; ++m)                 // in the order of memory
    for (std::size_t row = 0; row < rows; ++row) {
      const double along_s = turned[component_s] * std::sin(inclination[row]),
                   along_n = turned[component_n] * std::cos(inclination[row]);
      const std::size_t block = (m * rows + row) * 3 * size;
      const double *of_s = &wheel.values[block + component_s * size],
                   *of_n = &wheel.values[block + component_n * size];
      double *to = &pair.values[block + component_x * size], *so_far = &sum[row * size],
             *before = &last[row * size];
      for (std::size_t three = 0; three < size; three += 3)
        for (std::size_t j = 0; j < 3; ++j) {
          const std::size_t at = three + j;
          const double here = turned[j] * (along_s * of_s[at] + along_n * of_n[at]);
          so_far[at] += m > 0 ? half_step * (before[at] + here) : 0.0;
          before[at] = here;
          to[at] += so_far[at];
        }
    }
}

} // namespace bem_contact
