#include "bem_contact/influence/packed_file.hpp"
#include "bem_contact/influence/lower_triangle.hpp"
#include "bem_contact/influence/settings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bem_contact {

namespace {

/// The largest power of two that is not above `value`.
double power_of_two_below(double value) {
  return std::exp2(std::floor(std::log2(value)));
}

/// Where the number of a row and a column of one matrix lies; it has `n` rows.
double smallest_self(std::size_t n, const auto& number) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < n; ++row)
    least = std::min(least, number(row, row));
  return least;
}

void round_to(double step, double& value) {
  value = std::nearbyint(value / step) * step;
}

} // namespace

InfluenceFunction rounded(InfluenceFunction f) {
  validate(f);
  const std::size_t n = 3 * f.station_count(), count = f.wavenumber_count();
  for (std::size_t k = 0; k < count; ++k) {
    const auto self = [&](std::size_t row, std::size_t column) {
      return f.kernel[f.kernel_index(k, row, column)];
    };
    const double step = power_of_two_below(packed_step * smallest_self(n, self));
    for (std::size_t entry = 0; entry < f.kernel_size(); ++entry)
      round_to(step, f.kernel[entry * count + k]);
  }
  if (f.is_table()) {
    const auto self = [&](std::size_t row, std::size_t column) { return f.table[row * n + column]; };
    const double step = power_of_two_below(packed_step * smallest_self(n, self));
    for (double& value : f.table)
      round_to(step, value);
  }
  if (f.estimated_error >= 0)
    f.estimated_error += packed_step;
  return f;
}

} // namespace bem_contact
