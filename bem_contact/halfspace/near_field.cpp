#include "bem_contact/halfspace/near_field.hpp"

#include "bem_contact/halfspace/rectangle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bem_contact::halfspace {
namespace {

/// Any will do: resample() takes it away again.
constexpr double reference_distance = 100;
constexpr double enough = 1e-6; ///< of a number

/// How many lines serve the distances from .. to (absolute values) of rows ds wide; more than `most`: no
/// polynomial does.
int lines_for(double from, double to, double ds, int most) {
  const double half = 0.5 * (to - from);
  if (half <= 1e-12 * ds)
    return 1;
  const double apart = from - ds + half;
  if (!(from > ds))
    return most + 1;
  const double ratio = half / (2 * apart);
  int count = 1;
  for (double error = 4 * ratio; count <= most && error > enough; error *= ratio)
    ++count;
  return std::max(count, 2);
}

} // namespace

NearField::NearField(const Material& material, const ExpandOptions& options, std::span<const double> row_s,
                     double ds) {
  const std::size_t rows = row_s.size();
  std::vector<double> at; // distances of the lines
  mixes_.reserve(rows * (rows + 1) / 2);
  for (std::size_t d = 0; d < rows; ++d) {
    first_of_.push_back(mixes_.size());
    double low = row_s[d] - row_s[0], high = low;
    for (std::size_t j = 1; j + d < rows; ++j) {
      low = std::min(low, row_s[j + d] - row_s[j]);
      high = std::max(high, row_s[j + d] - row_s[j]);
    }
    const int count =
        lines_for(std::min(std::abs(low), std::abs(high)), std::max(std::abs(low), std::abs(high)), ds, most);
    if (count > most || count >= static_cast<int>(rows - d)) { // one line each, but for those equally far
      for (std::size_t j = 0; j + d < rows; ++j) {
        const double s = row_s[j + d] - row_s[j];
        if (j == 0 || std::abs(s - at.back()) > 1e-12 * ds)
          at.push_back(s);
        mixes_.push_back({at.size() - 1, 1, {1}});
      }
      continue;
    }
    const std::size_t first = at.size();
    for (int p = 0; p < count; ++p)
      at.push_back(0.5 * (low + high) - 0.5 * (high - low) * std::cos((p + 0.5) * std::numbers::pi / count));
    for (std::size_t j = 0; j + d < rows; ++j) {
      Mix mix{first, count, {}};
      const double s = row_s[j + d] - row_s[j];
      for (int p = 0; p < count; ++p) {
        double weight = 1;
        for (int q = 0; q < count; ++q)
          if (q != p)
            weight *= (s - at[first + static_cast<std::size_t>(q)]) /
                      (at[first + static_cast<std::size_t>(p)] - at[first + static_cast<std::size_t>(q)]);
        mix.weight[static_cast<std::size_t>(p)] = weight;
      }
      mixes_.push_back(mix);
    }
  }

  lines_ = at.size();
  const auto offsets = static_cast<std::size_t>(options.dx == 0 ? 1 : options.offsets);
  values_.resize(offsets * lines_ * 9);
  std::vector<Matrix3> line(offsets);
  for (std::size_t l = 0; l < lines_; ++l) {
    if (options.dx == 0)
      line[0] = averaged_plane_strain(material, at[l], ds, reference_distance);
    else
      averaged_line(material, at[l], options.dx, ds, line);
    for (std::size_t m = 0; m < offsets; ++m)
      for (std::size_t e = 0; e < 9; ++e)
        values_[(m * lines_ + l) * 9 + e] = line[m][e / 3][e % 3];
  }
}

} // namespace bem_contact::halfspace
