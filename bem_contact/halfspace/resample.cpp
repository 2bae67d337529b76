#include "bem_contact/halfspace/resample.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/simd.hpp"
#include "bem_contact/halfspace/near_field.hpp"
#include "bem_contact/influence/influence_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::halfspace {
namespace {

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

/// to (3 rows x wide) = the weights of the rows times `table` (3 stations x wide, rows `stride` apart).
BEM_CONTACT_WIDE void mix_rows(const double* table, std::size_t stride, std::size_t wide,
                               const RowWeights* rows, std::size_t count, double* to) {
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t i = 0; i < 3; ++i) {
      double* out = to + (3 * row + i) * wide;
      std::fill(out, out + wide, 0.0);
      for (int p = 0; p < rows[row].count; ++p) {
        const double weight = rows[row].weight[static_cast<std::size_t>(p)];
        const double* in = table + (3 * static_cast<std::size_t>(rows[row].first + p) + i) * stride;
        for (std::size_t e = 0; e < wide; ++e)
          out[e] += weight * in[e];
      }
    }
}

/// The function with its rows for stations: what expand() does is linear in the kernel, and the kernel has
/// far fewer wavenumbers than there are offsets, and fewer rows than stations.
InfluenceFunction with_rows(const InfluenceFunction& f, std::span<const RowWeights> rows, bool plane_strain) {
  InfluenceFunction out = without_numbers(f);
  out.stations.resize(rows.size());
  out.wavenumber = f.wavenumber;
  out.remote_self = f.remote_self;

  const auto [from, last] = std::minmax(rows.front().first, rows.back().first);
  const int to = last + rows.front().count;
  const std::size_t all = 3 * f.station_count(), n = 3 * rows.size(),
                    wide = 3 * static_cast<std::size_t>(to - from);
  std::vector<RowWeights> shifted(rows.begin(), rows.end()); // counted from the first station used
  for (RowWeights& row : shifted)
    row.first -= from;
  std::vector<double> half(n * wide), turned(wide * n), whole(n * n);
  // put(row, column, value) for the lower triangle of what the rows make of a matrix.
  const auto mix = [&](const double* matrix, std::size_t stride, auto&& put) {
    mix_rows(matrix, stride, wide, shifted.data(), shifted.size(), half.data());
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t e = 0; e < wide; ++e)
        turned[e * n + row] = half[row * wide + e];
    mix_rows(turned.data(), n, n, shifted.data(), shifted.size(), whole.data()); // [3 J + j][3 I + i]
    for (std::size_t row = 0; row < n; ++row)
      for (std::size_t column = 0; column <= row; ++column)
        put(row, column, whole[column * n + row]);
  };
  const std::size_t begin = 3 * static_cast<std::size_t>(from);
  if (f.is_table()) {
    out.table.resize(f.table_offsets() * n * n);
    for (std::size_t m = 0; m < f.table_offsets(); ++m)
      mix(&f.table[m * all * all + begin * (all + 1)], all,
          [&](std::size_t row, std::size_t column, double value) { // Maxwell-Betti to the last bit
            const int sign = parity(static_cast<int>(row % 3), static_cast<int>(column % 3));
            out.table[(m * n + row) * n + column] = value;
            out.table[(m * n + column) * n + row] = sign * value;
          });
    return out;
  }
  std::vector<double> used(wide * wide); // of the kernel
  for (std::size_t k = 0; k < (plane_strain ? 1 : f.wavenumber_count()); ++k) {
    for (std::size_t row = 0; row < wide; ++row)
      std::copy_n(&f.kernel[f.kernel_index(k, begin + row, begin)], row + 1, &used[row * wide]);
    mirror_lower(used, wide);
    mix(used.data(), wide, [&](std::size_t, std::size_t, double value) { out.kernel.push_back(value); });
  }
  out.remote.reserve(6 * f.wavenumber_count() * n);
  for (std::size_t m = 0; m < 6 * f.wavenumber_count(); ++m)
    for (const RowWeights& row : rows)
      for (std::size_t j = 0; j < 3; ++j) {
        double sum = 0;
        for (int q = 0; q < row.count; ++q)
          sum += row.weight[static_cast<std::size_t>(q)] *
                 f.remote[m * all + 3 * static_cast<std::size_t>(row.first + q) + j];
        out.remote.push_back(sum);
      }
  return out;
}

/// The near field of pairs of stations, interpolated to pairs of rows as the numbers themselves are: it
/// depends on how many stations lie between alone.
class StationsNearField {
public:
  StationsNearField(const Material& material, const ExpandOptions& options, std::span<const RowWeights> rows,
                    double width) {
    most_ = std::abs(rows.back().first - rows.front().first) + 3;
    std::vector<double> station_s;
    for (int d = 0; d <= most_; ++d)
      station_s.push_back(d * width);
    const NearField near(material, options, station_s, width);
    lines_.resize(static_cast<std::size_t>(options.offsets * (2 * most_ + 1)));
    for (int m = 0; m < options.offsets; ++m)
      for (int d = 0; d <= most_; ++d) {
        std::array<double, 9> ahead{};
        near.add(m, d, 0, 1, ahead.data());
        line(m, d) = ahead;
        for (std::size_t e = 0; e < 9 && d > 0; ++e) // load and sample change places
          line(m, -d)[e] =
              parity(static_cast<int>(e / 3), static_cast<int>(e % 3)) * ahead[e % 3 * 3 + e / 3];
      }
    for (const RowWeights& row_i : rows)
      for (const RowWeights& row_j : rows.first(static_cast<std::size_t>(&row_i - rows.data()) + 1)) {
        Mix mix{row_i.first - row_j.first - 3, {}};
        for (int p = 0; p < row_i.count; ++p)
          for (int q = 0; q < row_j.count; ++q)
            mix.weight[static_cast<std::size_t>(p - q + 3)] +=
                row_i.weight[static_cast<std::size_t>(p)] * row_j.weight[static_cast<std::size_t>(q)];
        mixes_.push_back(mix);
      }
  }

  /// Takes `factor` times the numbers [i][j] of a pair (counted row by row, J <= I) at offset m from `block`.
  void take(int m, std::size_t pair, double factor, std::array<double, 9>& block) const {
    const Mix& mix = mixes_[pair];
    for (int a = 0; a < 7; ++a)
      if (const double weight = factor * mix.weight[static_cast<std::size_t>(a)]; weight != 0) {
        const std::array<double, 9>& from = line(m, mix.first + a);
        for (std::size_t e = 0; e < 9; ++e)
          block[e] -= weight * from[e];
      }
  }

private:
  struct Mix {
    int first = 0; ///< stations between
    std::array<double, 7> weight{};
  };
  const std::array<double, 9>& line(int m, int d) const {
    return lines_[static_cast<std::size_t>(m * (2 * most_ + 1) + most_ + d)];
  }
  std::array<double, 9>& line(int m, int d) {
    return lines_[static_cast<std::size_t>(m * (2 * most_ + 1) + most_ + d)];
  }

  int most_ = 0;
  std::vector<std::array<double, 9>> lines_; ///< [offset][stations between, -most .. most]
  std::vector<Mix> mixes_;
};

} // namespace

InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds) {
  check_rows(function, row_s, ds);
  const double width = function.station_width, s0 = function.stations.front().s;

  std::vector<RowWeights> weights;
  for (const double s : row_s) {
    double position = (s - s0) / width;
    if (std::abs(position - std::round(position)) < 1e-9) // a station: exact, whatever the rounding of s
      position = std::round(position);
    weights.push_back(interpolate(position, static_cast<int>(function.station_count())));
  }
  ExpandOptions needed = options;
  if (const auto range = rows_are_stations(weights, ds, width)) {
    needed.first_station = range->first;
    needed.stations = range->second;
    return expand(function, needed);
  }

  // Per unit of load width the difference to the near field does not depend on the width, and is smooth.
  needed.first_station = 0;
  needed.stations = -1;
  InfluenceNumbers result = expand(with_rows(function, weights, options.dx == 0), needed);
  result.ds = ds;
  const StationsNearField of_stations(function.material, options, weights, width);
  const NearField of_rows(function.material, options, row_s, ds);
  const double factor = ds / width;
  std::array<double, 9> block{};
  for (int m = 0; m < options.offsets; ++m) {
    std::size_t pair = 0;
    for (int row_i = 0; row_i < result.rows; ++row_i)
      for (int row_j = 0; row_j <= row_i; ++row_j, ++pair) {
        for (std::size_t e = 0; e < 9; ++e)
          block[e] = factor * result.at(m, row_i, static_cast<int>(e / 3), row_j, static_cast<int>(e % 3));
        of_stations.take(m, pair, factor, block);
        of_rows.add(m, row_i, row_j, 1, block.data());
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < (row_i == row_j ? i + 1 : 3); ++j) {
            const double value = block[static_cast<std::size_t>(3 * i + j)];
            result.at(m, row_i, i, row_j, j) = value;
            result.at(m, row_j, j, row_i, i) = parity(i, j) * value;
          }
      }
  }
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
