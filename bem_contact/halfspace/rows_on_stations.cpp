#include "bem_contact/halfspace/rows_on_stations.hpp"

#include "bem_contact/base/simd.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bem_contact::halfspace {
namespace {

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

/// What the rows make of a matrix over the stations.
class RowMixer {
public:
  explicit RowMixer(std::span<const RowWeights> rows)
      : rows_(rows.begin(), rows.end()), size_(3 * rows.size()) {
    const auto [from, last] = std::minmax(rows.front().first, rows.back().first);
    const int to = last + rows.front().count;
    first_ = 3 * static_cast<std::size_t>(from);
    used_ = 3 * static_cast<std::size_t>(to - from);
    for (RowWeights& row : rows_) // counted from the first station used
      row.first -= from;
    half_.resize(size_ * used_);
    turned_.resize(used_ * size_);
    whole_.resize(size_ * size_);
  }

  std::size_t size() const { return size_; }   ///< rows and columns of the rows' matrix
  std::size_t first() const { return first_; } ///< first row and column of the stations' matrix that is used
  std::size_t used() const { return used_; }   ///< and how many

  /// put(row, column, value) for the lower triangle of the rows' matrix. `matrix`: the used part of the
  /// stations' one, its rows `stride` apart.
  template <class Put> void mix(const double* matrix, std::size_t stride, Put&& put) {
    mix_rows(matrix, stride, used_, rows_.data(), rows_.size(), half_.data());
    for (std::size_t row = 0; row < size_; ++row)
      for (std::size_t e = 0; e < used_; ++e)
        turned_[e * size_ + row] = half_[row * used_ + e];
    mix_rows(turned_.data(), size_, size_, rows_.data(), rows_.size(), whole_.data()); // [3 J + j][3 I + i]
    for (std::size_t row = 0; row < size_; ++row)
      for (std::size_t column = 0; column <= row; ++column)
        put(row, column, whole_[column * size_ + row]);
  }

private:
  std::vector<RowWeights> rows_;
  std::size_t size_, first_ = 0, used_ = 0;
  std::vector<double> half_, turned_, whole_;
};

std::vector<double> mixed_table(const InfluenceFunction& f, RowMixer& mixer, std::size_t n) {
  const std::size_t all = 3 * f.station_count();
  std::vector<double> table(f.table_offsets() * n * n);
  for (std::size_t m = 0; m < f.table_offsets(); ++m)
    mixer.mix(&f.table[m * all * all + mixer.first() * (all + 1)], all,
              [&](std::size_t row, std::size_t column, double value) { // Maxwell-Betti to the last bit
                const int sign = parity(static_cast<int>(row % 3), static_cast<int>(column % 3));
                table[(m * n + row) * n + column] = value;
                table[(m * n + column) * n + row] = sign * value;
              });
  return table;
}

std::vector<double> mixed_kernel(const InfluenceFunction& f, RowMixer& mixer, std::size_t wavenumbers) {
  const std::size_t used = mixer.used(), first = mixer.first();
  std::vector<double> kernel, part(used * used);
  kernel.reserve(wavenumbers * lower_size(mixer.size()));
  for (std::size_t k = 0; k < wavenumbers; ++k) {
    for (std::size_t row = 0; row < used; ++row)
      std::copy_n(&f.kernel[f.kernel_index(k, first + row, first)], row + 1, &part[row * used]);
    mirror_lower(part, used);
    mixer.mix(part.data(), used, [&](std::size_t, std::size_t, double value) { kernel.push_back(value); });
  }
  return kernel;
}

std::vector<double> mixed_remote(const InfluenceFunction& f, std::span<const RowWeights> rows) {
  const std::size_t all = 3 * f.station_count();
  std::vector<double> remote;
  remote.reserve(6 * f.wavenumber_count() * 3 * rows.size());
  for (std::size_t m = 0; m < 6 * f.wavenumber_count(); ++m)
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

} // namespace

RowWeights interpolate(double position, int stations) {
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

InfluenceFunction with_rows(const InfluenceFunction& f, std::span<const RowWeights> rows, bool plane_strain) {
  InfluenceFunction out = without_numbers(f);
  out.stations.resize(rows.size());
  RowMixer mixer(rows);
  if (f.is_table()) {
    out.table = mixed_table(f, mixer, 3 * rows.size());
    return out;
  }
  out.wavenumber = f.wavenumber;
  out.kernel = mixed_kernel(f, mixer, plane_strain ? 1 : f.wavenumber_count());
  out.remote = mixed_remote(f, rows);
  out.remote_self = f.remote_self;
  return out;
}

} // namespace bem_contact::halfspace
