#include "bem_contact/influence/expand_kernel.hpp"

#include "bem_contact/influence/dense.hpp"
#include "bem_contact/influence/remote_factor.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace bem_contact {
namespace {

using Eigen::MatrixXd;
using Table = Eigen::Map<const RowMajor>;

/// What "removed" takes from the kernel at each wavenumber is factor^T factor, factor 6 x 3 stations.
class Removed {
public:
  Removed(const InfluenceFunction& f, StationRange range, StructuralCompliance structural, Eigen::Index nk) {
    if (structural == StructuralCompliance::included)
      return;
    for (Eigen::Index k = 0; k < nk; ++k)
      factor_.push_back(remote_factor(f, range, k));
  }

  /// Takes it from `block`: rows 3 row .. 3 row + 2 and the first columns of the range.
  void take_from(Eigen::Ref<RowMajor> block, Eigen::Index k, Eigen::Index row) const {
    if (factor_.empty())
      return;
    const RowMajor& factor = factor_[static_cast<std::size_t>(k)];
    block.noalias() -= factor.middleCols(3 * row, 3).transpose() * factor.leftCols(block.cols());
  }

private:
  std::vector<RowMajor> factor_;
};

/// Components (i, j) even and odd in x; the sign is that of the sine series (influence_function.hpp): load
/// p_j cos kx gives u_x = +g_xj sin kx, load p_x cos kx gives u_i = -g_ix sin kx.
struct Entry {
  int i, j;
  double sign;
};
constexpr std::array<Entry, 5> even_entries = {{{0, 0, 1}, {1, 1, 1}, {1, 2, 1}, {2, 1, 1}, {2, 2, 1}}};
constexpr std::array<Entry, 4> odd_entries = {{{0, 1, 1}, {0, 2, 1}, {1, 0, -1}, {2, 0, -1}}};

/// The kernel of one row of stations against the columns J <= I: the entries even in x, and the odd ones.
struct KernelRow {
  MatrixXd even, odd; ///< [5 J + e][wavenumber], [4 J + e][wavenumber]
};

KernelRow kernel_row(const InfluenceFunction& f, StationRange range, Eigen::Index row, const Removed& removed,
                     Eigen::Index nk) {
  const Eigen::Index columns = row + 1, from = 3 * range.first;
  KernelRow kernel{MatrixXd(5 * columns, nk), MatrixXd(4 * columns, nk)};
  RowMajor block(3, 3 * columns);
  for (Eigen::Index k = 0; k < nk; ++k) {
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index j = 0; j < 3 * columns; ++j)
        block(i, j) =
            f.kernel[f.kernel_index(static_cast<std::size_t>(k), static_cast<std::size_t>(from + 3 * row + i),
                                    static_cast<std::size_t>(from + j))];
    removed.take_from(block, k, row);
    for (Eigen::Index column = 0; column < columns; ++column) {
      for (std::size_t e = 0; e < 5; ++e)
        kernel.even(5 * column + static_cast<Eigen::Index>(e), k) =
            block(even_entries[e].i, 3 * column + even_entries[e].j);
      for (std::size_t e = 0; e < 4; ++e)
        kernel.odd(4 * column + static_cast<Eigen::Index>(e), k) =
            odd_entries[e].sign * block(odd_entries[e].i, 3 * column + odd_entries[e].j);
    }
  }
  return kernel;
}

/// Writes the numbers of a row of stations, and by Maxwell-Betti those on the other side of the diagonal.
void put_row(InfluenceNumbers& result, Eigen::Index row, const MatrixXd& even, const MatrixXd& odd) {
  const Eigen::Index size = 3 * result.rows;
  for (Eigen::Index m = 0; m < result.offsets; ++m) {
    double* a = result.values.data() + m * size * size;
    const auto put = [&](const Entry& entry, Eigen::Index column, double value) {
      if (column == row && entry.i < entry.j)
        return;
      a[(3 * row + entry.i) * size + 3 * column + entry.j] = value;
      a[(3 * column + entry.j) * size + 3 * row + entry.i] = parity(entry.i, entry.j) * value;
    };
    for (Eigen::Index column = 0; column <= row; ++column) {
      for (std::size_t e = 0; e < 5; ++e)
        put(even_entries[e], column, even(5 * column + static_cast<Eigen::Index>(e), m));
      for (std::size_t e = 0; e < 4; ++e)
        put(odd_entries[e], column, odd(4 * column + static_cast<Eigen::Index>(e), m));
    }
  }
}

} // namespace

InfluenceNumbers expand_kernel(const InfluenceFunction& f, const ExpandOptions& o, StationRange range,
                               const Scaling& scaling) {
  InfluenceNumbers result{o.offsets, range.count, o.dx, f.station_width, {}};
  result.values.assign(result.expected_values(), 0.0);
  const Eigen::Index nk = o.dx == 0 ? 1 : static_cast<Eigen::Index>(f.wavenumber_count());
  const Removed removed(f, range, o.structural, nk);
  MatrixXd even = MatrixXd::Ones(1, 1), odd = MatrixXd::Zero(1, 1); // plane strain: odd ones vanish at k = 0
  if (o.dx > 0) {
    const SeriesWeights weights = series_weights(f.wavenumber, f.half_period, scaling.dx, o.offsets);
    even = Table(weights.even.data(), o.offsets, nk).transpose();
    odd = Table(weights.odd.data(), o.offsets, nk).transpose();
  }
  even *= scaling.load;
  odd *= scaling.load;
  for (Eigen::Index row = 0; row < range.count; ++row) {
    const KernelRow kernel = kernel_row(f, range, row, removed, nk);
    put_row(result, row, product(kernel.even, even), product(kernel.odd, odd));
  }
  return result;
}

} // namespace bem_contact
