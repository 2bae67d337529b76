#include "bem_contact/halfspace/flat_strip.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/kernels.hpp"
#include "bem_contact/halfspace/plane_strain.hpp"

#include <algorithm>
#include <string>

namespace bem_contact::halfspace {

InfluenceNumbers influence_numbers(const Material& material, double dx, double ds, int offsets, int rows,
                                   LineStore* known) {
  require_size(dx, "length dx");
  require_size(ds, "width ds");
  if (offsets < 1 || rows < 1)
    throw InputError("An influence table without elements was asked for",
                     std::to_string(offsets) + " offsets, " + std::to_string(rows) + " rows",
                     "Ask for at least one of each.");
  InfluenceNumbers result{offsets, rows, dx, ds, {}, true};
  result.values.resize(result.expected_values());
  LineStore only_now;
  LineStore& lines = known ? *known : only_now;
  for (int d = 0; d < rows; ++d) {
    const LineStore::Line line = lines.get(material, d * ds, dx, ds, static_cast<std::size_t>(offsets));
    const std::size_t next = 9 * static_cast<std::size_t>(2 * rows - 1); // offset
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double* from = line.values + static_cast<std::size_t>(3 * i + j) * line.offsets;
        double *ahead = &result.at(0, d, i, 0, j), *behind = &result.at(0, 0, j, d, i);
        const double sign = parity(i, j);
        for (int m = 0; m < offsets; ++m, ahead += next, behind += next) {
          *ahead = from[m];
          *behind = sign * from[m];
        }
      }
  }
  return result;
}

InfluenceNumbers plane_strain_numbers(const Material& material, double ds, int rows,
                                      double reference_distance) {
  if (rows < 1)
    throw InputError("An influence table without elements was asked for", std::to_string(rows) + " rows",
                     "Ask for at least one row.");
  InfluenceNumbers result{1, rows, 0, ds, {}};
  result.values.resize(9 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows));
  for (int d = 1 - rows; d < rows; ++d) {
    const Matrix3 m = averaged_plane_strain(material, d * ds, ds, reference_distance);
    for (int row = std::max(0, -d); row < rows && row + d < rows; ++row)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result.at(0, row + d, i, row, j) = m[i][j];
  }
  return result;
}

} // namespace bem_contact::halfspace
