#include "bem_contact/halfspace/rows_on_stations.hpp"

#include "bem_contact/halfspace/near_field.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::halfspace {
namespace {

/// 1 (station widths). A row this near to a station is that station: the rounding of s.
constexpr double station_snap = 1e-9;

/// Rows and columns of a matrix over the stations.
struct Used {
  std::size_t first, end;
  std::size_t count() const { return end - first; }
};
Used used_by(std::span<const RowWeights> rows) {
  const StationRange stations = used_stations(rows);
  return {3 * static_cast<std::size_t>(stations.first), 3 * static_cast<std::size_t>(stations.end())};
}

/// Of a matrix over the stations, each entry of which is a line of `length` values.
class RowMixer {
public:
  RowMixer(std::span<const RowWeights> rows, std::size_t length)
      : rows_(rows), length_(length), first_(used_by(rows).first), half_(used_by(rows).count() * length) {}

  /// The lower triangle over the rows, by rows of lines. line(row, column): of the stations' matrix.
  template <class Line> std::vector<double> mixed(const Line& line) {
    std::vector<double> lower(lower_size(3 * rows_.size()) * length_);
    double* to = lower.data();
    const auto half = [&](std::size_t station) { return half_line(station); };
    for (std::size_t row = 0; row < rows_.size(); ++row)
      for (std::size_t i = 0; i < 3; ++i) {
        mix_row(row, i, line);
        for (std::size_t column = 0; column <= row; ++column)
          for (std::size_t j = 0; j < (column < row ? 3 : i + 1); ++j, to += length_)
            mix(rows_[column], j, half, to);
      }
    return lower;
  }

private:
  double* half_line(std::size_t station) { return &half_[(station - first_) * length_]; }

  /// Component i of the row against the stations that it and the rows before it use.
  template <class Line> void mix_row(std::size_t row, std::size_t i, const Line& line) {
    const Used used = used_by(rows_.first(row + 1));
    for (std::size_t e = used.first; e < used.end; ++e) {
      const auto column = [&](std::size_t station) { return line(station, e); };
      mix(rows_[row], i, column, half_line(e));
    }
  }

  /// to = the weighted sum of the lines of component i of the row's stations
  template <class Line> void mix(const RowWeights& row, std::size_t i, const Line& line, double* to) const {
    LineMix sum;
    for (int p = 0; p < row.count; ++p)
      sum.add(line(3 * static_cast<std::size_t>(row.first + p) + i), row.weight[static_cast<std::size_t>(p)]);
    add_mix(sum, 0, 0, to, length_);
  }

  std::span<const RowWeights> rows_;
  std::size_t length_, first_;
  std::vector<double> half_; ///< of one row: [3 station + component][length]
};

std::vector<double> mixed_table(const InfluenceFunction& f, std::span<const RowWeights> rows) {
  const std::size_t all = 3 * f.station_count(), n = 3 * rows.size(), offsets = f.table_offsets();
  const Used used = used_by(rows);
  std::vector<double> lines(used.count() * used.count() * offsets), table(offsets * n * n);
  const auto line = [&](std::size_t row, std::size_t column) {
    return &lines[((row - used.first) * used.count() + column - used.first) * offsets];
  };
  for (std::size_t m = 0; m < offsets; ++m)
    for (std::size_t row = used.first; row < used.end; ++row)
      for (std::size_t column = used.first; column < used.end; ++column)
        line(row, column)[m] = f.table[(m * all + row) * all + column];
  const std::vector<double> lower = RowMixer(rows, offsets).mixed(line);
  const double* from = lower.data();
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column <= row; ++column)
      for (std::size_t m = 0; m < offsets; ++m, ++from) { // Maxwell-Betti to the last bit
        const int sign = parity(static_cast<int>(row % 3), static_cast<int>(column % 3));
        table[(m * n + column) * n + row] = sign * *from;
        table[(m * n + row) * n + column] = *from;
      }
  return table;
}

std::vector<double> mixed_remote(const InfluenceFunction& f, std::span<const RowWeights> rows,
                                 std::size_t wavenumbers) {
  const std::size_t all = 3 * f.station_count();
  std::vector<double> remote;
  remote.reserve(6 * wavenumbers * 3 * rows.size());
  for (std::size_t m = 0; m < 6 * wavenumbers; ++m)
    for (const RowWeights& row : rows)
      for (std::size_t j = 0; j < 3; ++j) {
        double sum = 0;
        for (int q = 0; q < row.count; ++q)
          sum += row.weight[static_cast<std::size_t>(q)] *
                 f.remote[m * all + 3 * static_cast<std::size_t>(row.first + q) + j];
        remote.push_back(sum);
      }
  return remote;
}

RowWeights weights_at(const InfluenceStrip& strip, double s) {
  const int stations = static_cast<int>(strip.station_count());
  const double width = strip.station_width;
  const int before =
      std::clamp(static_cast<int>(std::floor((s - strip.stations.front().s) / width)), 0, stations - 1);
  double beyond = (s - strip.stations[static_cast<std::size_t>(before)].s) / width;
  if (std::abs(beyond - std::round(beyond)) < station_snap)
    beyond = std::round(beyond);
  RowWeights w;
  w.count = std::min(4, stations);
  w.first = std::clamp(before + static_cast<int>(std::floor(beyond)) - 1, 0, stations - w.count);
  for (int a = 0; a < w.count; ++a) {
    double value = 1;
    for (int b = 0; b < w.count; ++b)
      if (b != a)
        value *= (before - w.first - b + beyond) / (a - b);
    w.weight[static_cast<std::size_t>(a)] = value;
  }
  return w;
}

} // namespace

std::vector<RowWeights> interpolate(const InfluenceStrip& strip, std::span<const double> row_s) {
  std::vector<RowWeights> rows;
  for (const double s : row_s)
    rows.push_back(weights_at(strip, s));
  return rows;
}

StationRange used_stations(std::span<const RowWeights> rows) {
  const auto [from, last] = std::ranges::minmax(rows, {}, &RowWeights::first);
  return {from.first, last.first + last.count - from.first};
}

InfluenceFunction with_rows(const InfluenceFunction& f, std::span<const RowWeights> rows, bool plane_strain) {
  InfluenceFunction out = without_numbers(f);
  out.stations.resize(rows.size());
  if (f.is_table()) {
    out.table = mixed_table(f, rows);
    return out;
  }
  const std::size_t wavenumbers = plane_strain ? 1 : f.wavenumber_count();
  const auto first = [&](const std::vector<double>& all, std::size_t each) {
    return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(wavenumbers * each));
  };
  out.wavenumber = first(f.wavenumber, 1);
  out.kernel = RowMixer(rows, wavenumbers).mixed([&](std::size_t row, std::size_t column) {
    return &f.kernel[f.kernel_index(0, row, column)];
  });
  out.remote = mixed_remote(f, rows, wavenumbers);
  out.remote_self = first(f.remote_self, 36);
  return out;
}

} // namespace bem_contact::halfspace
