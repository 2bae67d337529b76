#include "bem_contact/halfspace/resample.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/rectangle.hpp"
#include "bem_contact/influence/influence_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

using Line = std::vector<Matrix3>; ///< one matrix an offset

/// Half-space numbers of two rows s apart.
Line near_field(const Material& material, const ExpandOptions& options, double s, double ds) {
  if (options.dx == 0)
    return {averaged_plane_strain(material, s, ds, reference_distance)};
  Line line(static_cast<std::size_t>(options.offsets));
  averaged_line(material, s, options.dx, ds, line);
  return line;
}

/// Calls use(row_i, row_j, line) for every pair with row_j <= row_i; pairs equally far apart share a line.
template <class Use>
void for_each_near_field(const Material& material, const ExpandOptions& options,
                         std::span<const double> row_s, double ds, Use&& use) {
  for (std::size_t distance = 0; distance < row_s.size(); ++distance) {
    Line line;
    double known = std::numeric_limits<double>::infinity();
    for (std::size_t row_j = 0; row_j + distance < row_s.size(); ++row_j) {
      const double s = row_s[row_j + distance] - row_s[row_j];
      if (!(std::abs(s - known) <= 1e-12 * ds)) {
        line = near_field(material, options, s, ds);
        known = s;
      }
      use(static_cast<int>(row_j + distance), static_cast<int>(row_j), line);
    }
  }
}

/// Stations that are the rows themselves: their first and how many; nothing unless all are, in order.
std::optional<std::pair<int, int>> rows_are_stations(std::span<const RowWeights> rows, double ds,
                                                     double width) {
  if (std::abs(ds - width) > 1e-12 * width)
    return std::nullopt;
  const auto station = [](const RowWeights& w) {
    for (int a = 0; a < w.count; ++a)
      if (w.weight[static_cast<std::size_t>(a)] == 1)
        return w.first + a;
    return -1;
  };
  const int first = station(rows.front());
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (first < 0 || station(rows[i]) != first + static_cast<int>(i))
      return std::nullopt;
  return std::pair{first, static_cast<int>(rows.size())};
}

/// Adds `weight` interpolated from `table` (3 stations x 3 stations) to the 3 x 3 blocks J <= I of `to`
/// (3 rows x 3 rows), and sets the blocks J > I by Maxwell-Betti.
void interpolate_into(const double* table, int stations, std::span<const RowWeights> rows, int from,
                      double* to) {
  const std::size_t wide = 3 * static_cast<std::size_t>(stations), n = 3 * rows.size();
  std::vector<double> strip(3 * wide);
  for (std::size_t row_i = 0; row_i < rows.size(); ++row_i) {
    const RowWeights& wi = rows[row_i];
    std::ranges::fill(strip, 0.0);
    for (int p = 0; p < wi.count; ++p) {
      const double* source = table + static_cast<std::size_t>(wi.first + p - from) * 3 * wide;
      for (std::size_t e = 0; e < strip.size(); ++e)
        strip[e] += wi.weight[static_cast<std::size_t>(p)] * source[e];
    }
    for (std::size_t row_j = 0; row_j <= row_i; ++row_j) {
      const RowWeights& wj = rows[row_j];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
          if (row_i == row_j && j > i)
            continue; // by Maxwell-Betti, to the last bit
          double& value = to[(3 * row_i + i) * n + 3 * row_j + j];
          for (int q = 0; q < wj.count; ++q)
            value += wj.weight[static_cast<std::size_t>(q)] *
                     strip[i * wide + 3 * static_cast<std::size_t>(wj.first + q - from) + j];
          to[(3 * row_j + j) * n + 3 * row_i + i] = parity(static_cast<int>(i), static_cast<int>(j)) * value;
        }
    }
  }
}

} // namespace

InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds) {
  check_rows(function, row_s, ds);
  const double width = function.station_width, s0 = function.stations.front().s;

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

  if (const auto range = rows_are_stations(weights, ds, width)) {
    needed.first_station = range->first;
    needed.stations = range->second;
    return expand(function, needed);
  }

  // Per unit of load width the difference to the near field does not depend on the width.
  InfluenceNumbers smooth = expand(function, needed);
  std::vector<double> station_s;
  for (int i = from; i < to; ++i)
    station_s.push_back(i * width);
  for_each_near_field(function.material, options, station_s, width,
                      [&](int row_i, int row_j, const Line& line) {
                        for (int m = 0; m < options.offsets; ++m)
                          for (int i = 0; i < 3; ++i)
                            for (int j = 0; j < 3; ++j) {
                              const double near = line[static_cast<std::size_t>(m)][i][j];
                              smooth.at(m, row_i, i, row_j, j) -= near;
                              if (row_i != row_j)
                                smooth.at(m, row_j, j, row_i, i) -= parity(i, j) * near;
                            }
                      });
  for (double& value : smooth.values)
    value *= ds / width;

  InfluenceNumbers result{options.offsets, static_cast<int>(row_s.size()), options.dx, ds, {}};
  const std::size_t n = 3 * row_s.size(), wide = 3 * static_cast<std::size_t>(to - from);
  result.values.resize(static_cast<std::size_t>(options.offsets) * n * n);
  for_each_near_field(function.material, options, row_s, ds, [&](int row_i, int row_j, const Line& line) {
    for (int m = 0; m < options.offsets; ++m)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          result.at(m, row_i, i, row_j, j) = line[static_cast<std::size_t>(m)][i][j];
  });
  for (std::size_t m = 0; m < static_cast<std::size_t>(options.offsets); ++m)
    interpolate_into(smooth.values.data() + m * wide * wide, to - from, weights, from,
                     result.values.data() + m * n * n);
  return result;
}

InfluenceNumbers combine(const InfluenceNumbers& lower, const InfluenceNumbers& upper) {
  const auto same = [](double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
  };
  if (lower.offsets != upper.offsets || lower.rows != upper.rows || !same(lower.dx, upper.dx) ||
      !same(lower.ds, upper.ds))
    throw InputError("the influence numbers of two bodies cannot be added", "they belong to different grids",
                     "expand both for the same grid");
  if (lower.translational != upper.translational)
    return combine(spelled_out(lower), spelled_out(upper));
  InfluenceNumbers result = lower;
  for (int m = 0; m < lower.offsets; ++m)
    for (const auto& [row_i, row_j] : lower.stored_rows())
      for (int i = 0; i < 3; ++i) {
        const int sign = i == component_x ? 1 : -1;
        double* to = &result.at(m, row_i, i, row_j, 0);
        const double* add = &upper.values[upper.index(m, row_i, i, row_j, 0)];
        to[component_x] += sign * add[component_x];
        to[component_s] -= sign * add[component_s];
        to[component_n] -= sign * add[component_n];
      }
  return result;
}

} // namespace bem_contact::halfspace
