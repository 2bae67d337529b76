#include "bem_contact/sequence/radial_displacement.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace bem_contact {

void add_radial_displacement(const InfluenceNumbers& wheel, std::span<const double> inclination,
                             double radius, InfluenceNumbers& pair) {
  // The wheel's own frame is the contact frame turned by pi about x (base/conventions.hpp).
  constexpr std::array<double, 3> turned{1, -1, -1};
  const auto radial = [&](int m, int row_i, int row_j, int j) {
    return turned[j] *
           (turned[component_s] * std::sin(inclination[row_i]) * wheel.at(m, row_i, component_s, row_j, j) +
            turned[component_n] * std::cos(inclination[row_i]) * wheel.at(m, row_i, component_n, row_j, j));
  };
  const double half_step = 0.5 * wheel.dx / radius;
  const int rows = pair.rows;
  std::vector<double> sum(static_cast<std::size_t>(3) * rows * rows, 0.0), last = sum; // [I][J][j]
  for (int m = 0; m < pair.offsets; ++m) { // in the order of memory
    std::size_t at = 0;
    for (int row_i = 0; row_i < rows; ++row_i)
      for (int row_j = 0; row_j < rows; ++row_j)
        for (int j = 0; j < 3; ++j, ++at) {
          const double here = radial(m, row_i, row_j, j);
          if (m > 0)
            sum[at] += half_step * (last[at] + here);
          last[at] = here;
          pair.at(m, row_i, component_x, row_j, j) += sum[at];
        }
  }
}

} // namespace bem_contact
