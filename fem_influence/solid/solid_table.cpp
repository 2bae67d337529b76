#include "fem_influence/solid/solid_table.hpp"

#include "bem_contact/base/error.hpp"
#include "fem_influence/shared/body_description.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::fem {

InfluenceFunction as_table(const BodyFile& body, const ProfileCurve& curve, const SolidNumbers& numbers) {
  const std::size_t stations = numbers.stations.size(), n = 3 * stations;
  if (numbers.loads.size() != stations)
    throw InputError("The table of influence numbers would not be complete",
                     std::to_string(numbers.loads.size()) + " of " + std::to_string(stations) +
                         " stations were loaded",
                     "Load all of them.");
  InfluenceFunction f = describe(body, curve, numbers.stations);
  f.held = "all three displacements are zero on the mesh's group 'held' (physical surface 2)";
  f.method = "solid3d, degree " + std::to_string(body.solid.degree) + ", up to " +
             std::to_string(numbers.report.cells) + " hexahedra, " +
             std::to_string(body.solid.elements_per_load) + " along each side of the loaded element";
  f.table_dx = numbers.dx;
  f.table.assign(static_cast<std::size_t>(numbers.offsets) * n * n, 0.0);
  for (int m = 0; m < numbers.offsets; ++m)
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column <= row; ++column) {
        const auto i = static_cast<int>(row % 3), j = static_cast<int>(column % 3);
        const auto I = static_cast<int>(row / 3), J = static_cast<int>(column / 3);
        const double a = numbers.at(column / 3, j, m, I, i),
                     b = parity(i, j) * numbers.at(row / 3, i, m, J, j);
        const double self = std::sqrt(numbers.at(row / 3, i, 0, I, i) * numbers.at(column / 3, j, 0, J, j));
        f.betti_error = std::max(f.betti_error, 0.5 * std::abs(a - b) / self);
        // On the diagonal of an odd pair a and b are the same number.
        double* table = f.table.data() + static_cast<std::size_t>(m) * n * n;
        table[row * n + column] = 0.5 * (a + b);
        table[column * n + row] = parity(i, j) * table[row * n + column];
      }
  f.estimated_error = -1;
  return f;
}

double mesh_error(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                  const SolidNumbers& numbers) {
  BodyFile coarse = body;
  coarse.solid.elements_per_load = body.solid.elements_per_load / 2;
  if (coarse.solid.elements_per_load < 1)
    return -1;
  const std::size_t middle = numbers.loads.size() / 2;
  const int J = numbers.loads[middle];
  const SolidNumbers other = solid_numbers(coarse, curve, mesh, {.loads = {J}});
  double worst = 0;
  for (int j = 0; j < 3; ++j)
    for (int m = 0; m < numbers.offsets; ++m)
      for (int I = 0; I < static_cast<int>(numbers.stations.size()); ++I)
        for (int i = 0; i < 3; ++i) {
          const double self = std::sqrt(numbers.at(middle, i, 0, J, i) * numbers.at(middle, j, 0, J, j));
          worst = std::max(worst, std::abs(other.at(0, j, m, I, i) - numbers.at(middle, j, m, I, i)) / self);
        }
  return worst / 2;
}

} // namespace bem_contact::fem
