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

/// to (3 rows x wide) = the weights of the rows times `table` (3 stations x wide).
BEM_CONTACT_WIDE void mix_rows(const double* table, std::size_t wide, const RowWeights* rows,
                               std::size_t count, int from, double* to) {
  for (std::size_t row = 0; row < count; ++row)
    for (std::size_t i = 0; i < 3; ++i) {
      double* out = to + (3 * row + i) * wide;
      std::fill(out, out + wide, 0.0);
      for (int p = 0; p < rows[row].count; ++p) {
        const double weight = rows[row].weight[static_cast<std::size_t>(p)];
        const double* in = table + (3 * static_cast<std::size_t>(rows[row].first + p - from) + i) * wide;
        for (std::size_t e = 0; e < wide; ++e)
          out[e] += weight * in[e];
      }
    }
}

/// The numbers of all pairs of rows at one offset: interpolated from those of the stations, with the near
/// field.
class AtRows {
public:
  AtRows(std::span<const RowWeights> rows, int from, int stations)
      : rows_(rows), from_(from), wide_(3 * static_cast<std::size_t>(stations)), n_(3 * rows.size()),
        half_(n_ * wide_), turned_(wide_ * n_), whole_(n_ * n_) {}

  /// `table`: 3 stations x 3 stations; `to`: 3 rows x 3 rows. The blocks J > I are those of J < I by
  /// Maxwell-Betti, to the last bit.
  void write(const double* table, const NearField& near, int m, double* to) {
    mix_rows(table, wide_, rows_.data(), rows_.size(), from_, half_.data());
    for (std::size_t row = 0; row < n_; ++row)
      for (std::size_t e = 0; e < wide_; ++e)
        turned_[e * n_ + row] = half_[row * wide_ + e];
    mix_rows(turned_.data(), n_, rows_.data(), rows_.size(), from_, whole_.data()); // [3 J + j][3 I + i]
    std::array<double, 9> block{};
    for (std::size_t row_i = 0; row_i < rows_.size(); ++row_i)
      for (std::size_t row_j = 0; row_j <= row_i; ++row_j) {
        for (std::size_t e = 0; e < 9; ++e)
          block[e] = whole_[(3 * row_j + e % 3) * n_ + 3 * row_i + e / 3];
        near.add(m, static_cast<int>(row_i), static_cast<int>(row_j), 1, block.data());
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < (row_i == row_j ? i + 1 : 3); ++j) {
            const double value = block[3 * i + j];
            to[(3 * row_i + i) * n_ + 3 * row_j + j] = value;
            to[(3 * row_j + j) * n_ + 3 * row_i + i] =
                parity(static_cast<int>(i), static_cast<int>(j)) * value;
          }
      }
  }

private:
  std::span<const RowWeights> rows_;
  int from_;
  std::size_t wide_, n_;
  std::vector<double> half_, turned_, whole_;
};

/// What is smooth: `numbers` of stations less their near field, per unit of load width.
void take_near_field(InfluenceNumbers& numbers, const NearField& near, double factor) {
  std::array<double, 9> block{};
  for (int m = 0; m < numbers.offsets; ++m)
    for (int row_i = 0; row_i < numbers.rows; ++row_i)
      for (int row_j = 0; row_j <= row_i; ++row_j) {
        for (std::size_t e = 0; e < 9; ++e)
          block[e] = factor * numbers.at(m, row_i, static_cast<int>(e / 3), row_j, static_cast<int>(e % 3));
        near.add(m, row_i, row_j, -factor, block.data());
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < (row_i == row_j ? i + 1 : 3); ++j) {
            const double value = block[static_cast<std::size_t>(3 * i + j)];
            numbers.at(m, row_i, i, row_j, j) = value;
            numbers.at(m, row_j, j, row_i, i) = parity(i, j) * value;
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
  take_near_field(smooth, NearField(function.material, options, station_s, width), ds / width);

  InfluenceNumbers result{options.offsets, static_cast<int>(row_s.size()), options.dx, ds, {}};
  const std::size_t n = 3 * row_s.size(), wide = 3 * static_cast<std::size_t>(to - from);
  result.values.resize(static_cast<std::size_t>(options.offsets) * n * n);
  const NearField near(function.material, options, row_s, ds);
  AtRows rows(weights, from, to - from);
  for (int m = 0; m < options.offsets; ++m)
    rows.write(smooth.values.data() + static_cast<std::size_t>(m) * wide * wide, near, m,
               result.values.data() + static_cast<std::size_t>(m) * n * n);
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
