#include "bem_contact/halfspace/resample.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/halfspace/near_field.hpp"
#include "bem_contact/halfspace/rows_on_stations.hpp"
#include "bem_contact/halfspace/settings.hpp"
#include "bem_contact/influence/requirements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace bem_contact::halfspace {
namespace {

/// 1 (row widths). How much of the outermost half row must lie on the strip. Less than a half, because rows
/// that are equally wide on one body are up to 1 % narrower or wider on the other.
constexpr double required_half_row = 0.49;

void check_rows(const InfluenceFunction& function, std::span<const double> row_s, double ds) {
  if (row_s.empty() || !(std::isfinite(ds) && ds > 0))
    throw InputError("Influence numbers cannot be resampled",
                     std::to_string(row_s.size()) + " rows of " + std::to_string(ds) + " mm",
                     "Give at least one row and a width above 0.");
  for (std::size_t i = 1; i < row_s.size(); ++i)
    if (!((row_s[i] - row_s[i - 1]) * (row_s[row_s.size() - 1] - row_s[0]) > 0))
      throw InputError("Influence numbers cannot be resampled",
                       "the rows are not in the order of the arc length",
                       "Give ascending or descending rows.");
  const auto [low, high] = std::minmax(row_s.front(), row_s.back());
  require_strip(function, low - required_half_row * ds, high + required_half_row * ds);
}

/// If the rows are stations, one after the other: the first station and how many.
std::optional<StationRange> rows_are_stations(std::span<const RowWeights> rows, double ds, double width) {
  if (std::abs(ds - width) > same_distance * width)
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
  return StationRange{first, static_cast<int>(rows.size())};
}

/// Half-space numbers of pairs of stations, interpolated to pairs of rows exactly as with_rows() interpolates
/// the file's numbers. They depend only on how many stations lie between the two.
class StationsNearField {
public:
  /// `width`: of a station, mm.
  StationsNearField(const Material& material, const ExpandOptions& options, std::span<const RowWeights> rows,
                    double width, LineStore& known) {
    most_ = std::abs(rows.back().first - rows.front().first) + 3;
    std::vector<double> station_s;
    for (int d = 0; d <= most_; ++d)
      station_s.push_back(d * width);
    const NearField near(material, options, station_s, width, known);
    const std::size_t offsets = offsets_ = static_cast<std::size_t>(options.offsets);
    blocks_.resize((2 * static_cast<std::size_t>(most_) + 1) * 9 * offsets);
    for (int d = 0; d <= most_; ++d) {
      LineMix mix;
      near.add_to(mix, d, 0, 1);
      double* ahead = block(d);
      for (std::size_t e = 0; e < 9; ++e)
        add_mix(mix, e * offsets, 0, ahead + e * offsets, offsets);
      for (std::size_t e = 0; e < 9 && d > 0; ++e) // load and sample change places
        for (std::size_t m = 0; m < offsets; ++m)
          block(-d)[e * offsets + m] = parity(static_cast<int>(e / 3), static_cast<int>(e % 3)) *
                                       ahead[(e % 3 * 3 + e / 3) * offsets + m];
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

  /// Takes `factor` times the numbers of a pair (counted row by row, J <= I) from a mix.
  void take_from(LineMix& to, std::size_t pair, double factor) const {
    const Mix& mix = mixes_[pair];
    for (int a = 0; a < 7; ++a)
      if (const double weight = mix.weight[static_cast<std::size_t>(a)]; weight != 0)
        to.add(&blocks_[block_index(mix.first + a)], -factor * weight);
  }

private:
  struct Mix {
    int first = 0; ///< stations between
    std::array<double, 7> weight{};
  };
  std::size_t block_index(int d) const { return static_cast<std::size_t>(most_ + d) * 9 * offsets_; }
  double* block(int d) { return &blocks_[block_index(d)]; }

  int most_ = 0;
  std::size_t offsets_ = 0;
  std::vector<double> blocks_; ///< [stations between, -most .. most][i][j][offset]
  std::vector<Mix> mixes_;
};

} // namespace

StationRange stations_under(const InfluenceStrip& strip, std::span<const double> row_s) {
  return used_stations(interpolate(strip, row_s));
}

void resample_lines(const InfluenceFunction& function, const ExpandOptions& options,
                    std::span<const double> row_s, double ds, const TakeLines& take, LineStore* known) {
  check_rows(function, row_s, ds);
  const double width = function.station_width;
  const std::vector<RowWeights> weights = interpolate(function, row_s);
  ExpandOptions needed = options;
  if (const auto range = rows_are_stations(weights, ds, width)) {
    needed.first_station = range->first;
    needed.stations = range->count;
    return expand_lines(function, needed, take);
  }

  // Per unit of load width the difference to the near field does not depend on the width, and is smooth.
  needed.first_station = 0;
  needed.stations = -1;
  LineStore only_now;
  LineStore& lines_known = known ? *known : only_now;
  const StationsNearField of_stations(function.material, options, weights, width, lines_known);
  const NearField of_rows(function.material, options, row_s, ds, lines_known);
  const double factor = ds / width;
  const auto to_rows = [&](NumberLines& lines) {
    const auto first_pair = static_cast<std::size_t>(lines.row() * lines.columns() / 2);
    const auto offsets = static_cast<std::size_t>(lines.offsets());
    for (int column = 0; column < lines.columns(); ++column) {
      LineMix mix;
      of_stations.take_from(mix, first_pair + static_cast<std::size_t>(column), factor);
      of_rows.add_to(mix, lines.row(), column, 1);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < (column == lines.row() ? i + 1 : 3); ++j)
          add_mix(mix, static_cast<std::size_t>(3 * i + j) * offsets, factor, lines.line(column, i, j).data(),
                  offsets);
    }
    take(lines);
  };
  expand_lines(with_rows(function, weights, options.dx == 0), needed, to_rows);
}

InfluenceNumbers resample(const InfluenceFunction& function, const ExpandOptions& options,
                          std::span<const double> row_s, double ds, LineStore* known) {
  InfluenceNumbers result{options.offsets, static_cast<int>(row_s.size()), options.dx, ds, {}};
  result.values.resize(result.expected_values());
  resample_lines(
      function, options, row_s, ds, [&](NumberLines& lines) { lines.write_to(result); }, known);
  return result;
}

} // namespace bem_contact::halfspace
