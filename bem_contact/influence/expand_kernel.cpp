#include "bem_contact/influence/expand_kernel.hpp"

#include "bem_contact/base/parallel.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/influence/remote_factor.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <Eigen/Core>

#include <algorithm>
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
    for (Eigen::Index i = 0; i < 3; ++i)
      for (Eigen::Index motion = 0; motion < 6; ++motion)
        block.row(i) -= factor(motion, 3 * row + i) * factor.row(motion).head(block.cols());
  }

private:
  std::vector<RowMajor> factor_;
};

/// The kernel of one row of stations against the columns J <= I, as NumberLines has the numbers. The sign is
/// that of the sine series (influence_function.hpp): load p_j cos kx gives u_x = +g_xj sin kx, load p_x cos
/// kx gives u_i = -g_ix sin kx.
struct KernelRow {
  MatrixXd even, odd; ///< [wavenumber][5 J + e], [wavenumber][4 J + e], column-major
};

KernelRow kernel_row(const InfluenceFunction& f, StationRange range, Eigen::Index row, const Removed& removed,
                     Eigen::Index nk) {
  const Eigen::Index columns = row + 1, from = 3 * range.first;
  KernelRow kernel{MatrixXd(nk, 5 * columns), MatrixXd(nk, 4 * columns)};
  RowMajor block(3, 3 * columns);
  for (Eigen::Index k = 0; k < nk; ++k) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const auto whole_row = static_cast<std::size_t>(from + 3 * row + i),
                 first = static_cast<std::size_t>(from);
      const Eigen::Index stored = 3 * row + i + 1; // up to the diagonal; the rest of its block is symmetric
      std::copy_n(&f.kernel[f.kernel_index(static_cast<std::size_t>(k), whole_row, first)], stored,
                  &block(i, 0));
      for (Eigen::Index j = stored; j < 3 * columns; ++j)
        block(i, j) = f.kernel[f.kernel_index(static_cast<std::size_t>(k), whole_row,
                                              first + static_cast<std::size_t>(j))];
    }
    removed.take_from(block, k, row);
    for (Eigen::Index column = 0; column < columns; ++column) {
      for (Eigen::Index e = 0; e < 5; ++e) {
        const auto [i, j] = NumberLines::even_entries[static_cast<std::size_t>(e)];
        kernel.even(k, 5 * column + e) = block(i, 3 * column + j);
      }
      for (Eigen::Index e = 0; e < 4; ++e) {
        const auto [i, j] = NumberLines::odd_entries[static_cast<std::size_t>(e)];
        kernel.odd(k, 4 * column + e) = (i == component_x ? 1 : -1) * block(i, 3 * column + j);
      }
    }
  }
  return kernel;
}

} // namespace

InfluenceNumbers expand_kernel(const InfluenceFunction& f, const ExpandOptions& o, StationRange range,
                               const Scaling& scaling, const ChangeLines& change) {
  InfluenceNumbers result{o.offsets, range.count, o.dx, f.station_width, {}};
  result.values.resize(result.expected_values());
  const Eigen::Index nk = o.dx == 0 ? 1 : static_cast<Eigen::Index>(f.wavenumber_count());
  const Removed removed(f, range, o.structural, nk);
  MatrixXd even = MatrixXd::Ones(1, 1), odd = MatrixXd::Zero(1, 1); // plane strain: odd ones vanish at k = 0
  if (o.dx > 0) {
    const SeriesWeights weights = series_weights(f.wavenumber, f.half_period, scaling.dx, o.offsets);
    even = Table(weights.even.data(), o.offsets, nk);
    odd = Table(weights.odd.data(), o.offsets, nk);
  }
  even *= scaling.load;
  odd *= scaling.load;
  // A row has one block more than the one before. The first and the last together, then the second and the last but
  // one, and so on, are work for each thread alike.
  const int pairs = (range.count + 1) / 2;
  in_parts(o.threads, pairs, [&](int pair, int end, int) {
    NumberLines lines(range.count, o.offsets);
    const auto write = [&](int row) {
      const KernelRow kernel = kernel_row(f, range, row, removed, nk);
      lines.begin(row);
      multiply(even, kernel.even, lines.even());
      multiply(odd, kernel.odd, lines.odd());
      if (change)
        change(lines);
      lines.write_to(result);
    };
    for (; pair < end; ++pair) {
      write(pair);
      if (const int opposite = range.count - 1 - pair; opposite != pair)
        write(opposite);
    }
  });
  return result;
}

} // namespace bem_contact
