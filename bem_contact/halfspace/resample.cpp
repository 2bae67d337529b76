#include "bem_contact/halfspace/resample.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/rectangle.hpp"
#include "bem_contact/influence/influence_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace bem_contact::halfspace {
namespace {

/// Any will do: it drops out of the difference.
constexpr double reference_distance = 100;

/// Lagrange weights of `count` (at most 4) neighbouring stations for one row.
struct RowWeights {
  int first = 0, count = 0;
  std::array<double, 4> weight{};
};

RowWeights interpolate(double position, int stations) { // position in station widths from the first centre
  RowWeights w;
  w.count = std::min(4, stations);
  w.first = std::clamp(static_cast<int>(std::floor(position)) - 1, 0, stations - w.count);
  for (int a = 0; a < w.count; ++a) {
    double value = 1;
    for (int b = 0; b < w.count; ++b)
      if (b != a)
        value *= (position - (w.first + b)) / (a - b);
    w.weight[static_cast<std::size_t>(a)] = value;
  }
  return w;
}

void check_rows(const InfluenceFunction& function, std::span<const double> row_s, double ds) {
  if (row_s.empty() || !(std::isfinite(ds) && ds > 0))
    throw InputError("influence numbers cannot be resampled",
                     std::to_string(row_s.size()) + " rows of " + std::to_string(ds) + " mm",
                     "give at least one row and a width above 0");
  for (std::size_t i = 1; i < row_s.size(); ++i)
    if (!((row_s[i] - row_s[i - 1]) * (row_s[row_s.size() - 1] - row_s[0]) > 0))
      throw InputError("influence numbers cannot be resampled",
                       "the rows are not in the order of the arc length",
                       "give ascending or descending rows");
  // Rows of equal width on one body are a hair longer or shorter on the other: 1 % of a row is allowed.
  const auto [low, high] = std::minmax(row_s.front(), row_s.back());
  require_strip(function, low - 0.49 * ds, high + 0.49 * ds);
}

/// Half-space number of two rows s apart.
Matrix3 near_field(const Material& material, double x, double s, double dx, double ds) {
  return dx == 0 ? averaged_plane_strain(material, s, ds, reference_distance)
                 : averaged(material, x, s, dx / 2, ds / 2);
}

} // namespace

InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds) {
  check_rows(function, row_s, ds);
  const double width = function.station_width, s0 = function.stations.front().s;
  const auto rows = static_cast<int>(row_s.size());

  std::vector<RowWeights> weights;
  int from = static_cast<int>(function.station_count()), to = 0;
  for (const double s : row_s) {
    double position = (s - s0) / width;
    if (std::abs(position - std::round(position)) < 1e-9) // a station: exact, whatever the rounding of s
      position = std::round(position);
    weights.push_back(interpolate(position, static_cast<int>(function.station_count())));
    from = std::min(from, weights.back().first);
    to = std::max(to, weights.back().first + weights.back().count);
  }
  ExpandOptions needed = options;
  needed.first_station = from;
  needed.stations = to - from;

  // Per unit of load width the difference to the near field does not depend on the width.
  InfluenceNumbers smooth = expand(function, needed);
  const InfluenceNumbers near =
      options.dx == 0 ? plane_strain_numbers(function.material, width, smooth.rows, reference_distance)
                      : numbers(function.material, options.dx, width, options.offsets, smooth.rows);
  for (std::size_t i = 0; i < smooth.values.size(); ++i)
    smooth.values[i] = (smooth.values[i] - near.values[i]) * (ds / width);

  InfluenceNumbers result{options.offsets, rows, options.dx, ds, {}};
  result.values.resize(9 * static_cast<std::size_t>(options.offsets) * row_s.size() * row_s.size());
  for (int m = 0; m < options.offsets; ++m)
    for (int row_i = 0; row_i < rows; ++row_i)
      for (int row_j = 0; row_j <= row_i; ++row_j) {
        const auto& wi = weights[static_cast<std::size_t>(row_i)];
        const auto& wj = weights[static_cast<std::size_t>(row_j)];
        Matrix3 a = near_field(
            function.material, m * options.dx,
            row_s[static_cast<std::size_t>(row_i)] - row_s[static_cast<std::size_t>(row_j)], options.dx, ds);
        for (int p = 0; p < wi.count; ++p)
          for (int q = 0; q < wj.count; ++q) {
            const double w = wi.weight[static_cast<std::size_t>(p)] * wj.weight[static_cast<std::size_t>(q)];
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j)
                a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] +=
                    w * smooth.at(m, wi.first + p - from, i, wj.first + q - from, j);
          }
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const double value = a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            result.at(m, row_i, i, row_j, j) = value;
            if (row_i != row_j || j < i) // Maxwell-Betti to the last bit
              result.at(m, row_j, j, row_i, i) = parity(i, j) * value;
          }
      }
  return result;
}

InfluenceNumbers combine(const InfluenceNumbers& lower, const InfluenceNumbers& upper) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
  };
  if (lower.offsets != upper.offsets || lower.rows != upper.rows ||
      lower.values.size() != upper.values.size() || !same(lower.dx, upper.dx) || !same(lower.ds, upper.ds))
    throw InputError("the influence numbers of two bodies cannot be added", "they belong to different grids",
                     "expand both for the same grid");
  InfluenceNumbers result = lower;
  const auto n = 3 * static_cast<std::size_t>(lower.rows);
  for (std::size_t e = 0; e < result.values.size(); ++e) {
    const bool row_is_x = (e / n) % n % 3 == component_x, column_is_x = e % n % 3 == component_x;
    result.values[e] += (row_is_x == column_is_x ? 1 : -1) * upper.values[e];
  }
  return result;
}

} // namespace bem_contact::halfspace
