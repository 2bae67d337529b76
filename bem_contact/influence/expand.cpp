#include "bem_contact/influence/expand.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace bem_contact {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Eigen::MatrixXd;
using Table = Eigen::Map<const RowMajor>;

struct StationRange {
  Eigen::Index first = 0, count = 0;
};

StationRange checked_range(const InfluenceFunction& f, const ExpandOptions& o) {
  const auto total = static_cast<int>(f.station_count());
  const int count = o.stations < 0 ? total - o.first_station : o.stations;
  if (o.first_station < 0 || count < 1 || o.first_station > total - count)
    throw InputError("stations were asked for that the influence functions of '" + f.body + "' do not have",
                     std::to_string(count) + " from number " + std::to_string(o.first_station) + " on, of " +
                         std::to_string(total),
                     "ask for stations on the strip");
  return {o.first_station, count};
}

/// Element length on the reference radius and the load's scale: A(x; a) = (Rc/R) A_ref(x R/Rc; a R/Rc), since
/// the kernel's unit load is per reference area.
struct Scaling {
  double dx = 0, load = 1;
};

Scaling checked_scaling(const InfluenceFunction& f, const ExpandOptions& o) {
  if (!(std::isfinite(o.dx) && o.dx >= 0) || o.offsets < 1)
    throw InputError("influence numbers cannot be expanded",
                     "dx = " + std::to_string(o.dx) + " mm, " + std::to_string(o.offsets) + " offsets",
                     "give dx >= 0 and at least one offset");
  if (!(std::isfinite(o.contact_radius) && o.contact_radius >= 0))
    throw InputError("influence numbers cannot be expanded",
                     "contact radius " + std::to_string(o.contact_radius) + " mm", "give a radius above 0");
  Scaling scaling{o.dx, 1};
  if (f.invariance == Invariance::revolution && o.contact_radius > 0) {
    scaling.load = o.contact_radius / f.reference_radius;
    scaling.dx = o.dx / scaling.load;
  }
  if (f.is_table())
    return scaling;
  if (o.dx == 0) {
    if (o.offsets != 1)
      throw InputError("plane strain has no offsets along x", std::to_string(o.offsets) + " were asked for",
                       "ask for one offset, or give dx");
    return scaling;
  }
  const double largest = f.wavenumber.back();
  if (f.wavenumber_count() < 3 || largest * scaling.dx / 2 < 5 * (1 - 1e-9))
    throw InputError("the influence functions of '" + f.body +
                         "' are too coarse along x for dx = " + std::to_string(o.dx) + " mm",
                     largest > 0 ? "they serve dx >= " + std::to_string(10 / largest * scaling.load) + " mm"
                                 : "they hold plane strain only",
                     "use longer elements, or compute them with a smaller harmonic.shortest_dx");
  if (o.offsets * scaling.dx > f.half_period)
    throw InputError("the patch is longer than the half period of the influence functions of '" + f.body +
                         "'",
                     std::to_string(o.offsets) + " elements of " + std::to_string(o.dx) +
                         " mm, half period " + std::to_string(f.half_period) + " mm",
                     "use a shorter patch, or compute them with a larger harmonic.half_period");
  return scaling;
}

/// What "removed" takes from the kernel at each wavenumber is factor^T factor, factor 6 x 3 stations.
class Removed {
public:
  Removed(const InfluenceFunction& f, StationRange range, StructuralCompliance structural, Eigen::Index nk) {
    if (structural == StructuralCompliance::included)
      return;
    for (Eigen::Index k = 0; k < nk; ++k)
      factor_.push_back(factor_at(f, range, k));
  }

  /// Takes it from `block`: rows 3 row .. 3 row + 2 and the first columns of the range.
  void take_from(Eigen::Ref<RowMajor> block, Eigen::Index k, Eigen::Index row) const {
    if (factor_.empty())
      return;
    const RowMajor& factor = factor_[static_cast<std::size_t>(k)];
    block.noalias() -= factor.middleCols(3 * row, 3).transpose() * factor.leftCols(block.cols());
  }

private:
  static RowMajor factor_at(const InfluenceFunction& f, StationRange range, Eigen::Index k) {
    const auto n = static_cast<Eigen::Index>(3 * f.station_count());
    Eigen::Matrix<double, 6, 6> self = Table(f.remote_self.data() + k * 36, 6, 6);
    // Displacements and rotations differ in unit: scale to a unit diagonal before the factorization.
    const Eigen::Matrix<double, 6, 1> diagonal = self.diagonal();
    if (diagonal.minCoeff() > 0) {
      const Eigen::Matrix<double, 6, 1> scale = diagonal.cwiseSqrt().cwiseInverse();
      self = scale.asDiagonal() * self * scale.asDiagonal();
      const Eigen::LLT<Eigen::Matrix<double, 6, 6>> cholesky(self);
      if (cholesky.info() == Eigen::Success && cholesky.rcond() > 1e-13) {
        RowMajor factor =
            scale.asDiagonal() *
            Table(f.remote.data() + k * 6 * n, 6, n).middleCols(3 * range.first, 3 * range.count);
        cholesky.matrixL().solveInPlace(factor);
        return factor;
      }
    }
    throw InputError("the structural compliance of '" + f.body + "' cannot be removed",
                     "the remote section's own compliance is not positive definite at wavenumber " +
                         std::to_string(f.wavenumber[static_cast<std::size_t>(k)]) + " 1/mm",
                     "use structural compliance 'included', or compute the file again");
  }

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

/// Elements of `parts` elements of the table: whole multiples alone.
int checked_parts(const InfluenceFunction& f, const ExpandOptions& o, const Scaling& scaling) {
  if (o.structural != StructuralCompliance::included)
    throw InputError("the structural compliance of '" + f.body + "' cannot be removed",
                     "its file is a table of influence numbers and knows no remote section",
                     "use structural compliance 'included'");
  const double parts = scaling.dx / f.table_dx;
  if (!(parts >= 1 - 1e-9) || std::abs(parts - std::round(parts)) > 1e-9 * parts)
    throw InputError("the influence numbers of '" + f.body + "' do not serve dx = " + std::to_string(o.dx) +
                         " mm",
                     "they are a table of elements " + std::to_string(f.table_dx * scaling.load) +
                         " mm long at this radius",
                     "use that length or a whole multiple of it, or compute them with another solid.dx");
  if (o.offsets * parts > static_cast<double>(f.table_offsets()) + 0.5)
    throw InputError("the patch is longer than the table of influence numbers of '" + f.body + "'",
                     std::to_string(o.offsets) + " elements of " + std::to_string(o.dx) +
                         " mm, the table has " + std::to_string(f.table_offsets()) + " of " +
                         std::to_string(f.table_dx * scaling.load) + " mm",
                     "use a shorter patch, or compute it with more solid.offsets");
  return static_cast<int>(std::lround(parts));
}

/// An element of q table elements under a load on q of them: A(M) = 1/q sum_c (q - |c|) A_table(M q + c).
InfluenceNumbers expand_table(const InfluenceFunction& f, const ExpandOptions& o, StationRange range,
                              const Scaling& scaling) {
  const int q = checked_parts(f, o, scaling);
  const auto size = static_cast<std::size_t>(3 * range.count),
             from = static_cast<std::size_t>(3 * range.first), all = 3 * f.station_count();
  InfluenceNumbers result{o.offsets, static_cast<int>(range.count), o.dx, f.station_width, {}};
  result.values.assign(static_cast<std::size_t>(o.offsets) * size * size, 0.0);
  for (int m = 0; m < o.offsets; ++m)
    for (int c = 1 - q; c < q; ++c) {
      const int offset = m * q + c;
      const double weight = scaling.load * (q - std::abs(c)) / q;
      const double* a = f.table.data() + static_cast<std::size_t>(std::abs(offset)) * all * all;
      double* to = result.values.data() + static_cast<std::size_t>(m) * size * size;
      for (std::size_t row = 0; row < size; ++row)
        for (std::size_t column = 0; column < size; ++column) {
          const int sign = offset < 0 ? parity(static_cast<int>(row % 3), static_cast<int>(column % 3)) : 1;
          to[row * size + column] += weight * sign * a[(from + row) * all + from + column];
        }
    }
  return result;
}

} // namespace

InfluenceNumbers expand(const InfluenceFunction& f, const ExpandOptions& o) {
  const StationRange range = checked_range(f, o);
  const Scaling scaling = checked_scaling(f, o);
  if (f.is_table())
    return expand_table(f, o, range, scaling);
  const Eigen::Index size = 3 * range.count, from = 3 * range.first;
  InfluenceNumbers result{o.offsets, static_cast<int>(range.count), o.dx, f.station_width, {}};
  result.values.assign(static_cast<std::size_t>(o.offsets * size * size), 0.0);

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

  // Row by row of stations the columns J <= I alone; the others by Maxwell-Betti, which keeps it exact.
  RowMajor block;
  MatrixXd even_kernel, odd_kernel;
  for (Eigen::Index row = 0; row < range.count; ++row) {
    const Eigen::Index columns = row + 1;
    even_kernel.resize(5 * columns, nk);
    odd_kernel.resize(4 * columns, nk);
    block.resize(3, 3 * columns);
    for (Eigen::Index k = 0; k < nk; ++k) {
      for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index j = 0; j < 3 * columns; ++j)
          block(i, j) = f.kernel[f.kernel_index(static_cast<std::size_t>(k),
                                                static_cast<std::size_t>(from + 3 * row + i),
                                                static_cast<std::size_t>(from + j))];
      removed.take_from(block, k, row);
      for (Eigen::Index column = 0; column < columns; ++column) {
        for (std::size_t e = 0; e < 5; ++e)
          even_kernel(5 * column + static_cast<Eigen::Index>(e), k) =
              block(even_entries[e].i, 3 * column + even_entries[e].j);
        for (std::size_t e = 0; e < 4; ++e)
          odd_kernel(4 * column + static_cast<Eigen::Index>(e), k) =
              odd_entries[e].sign * block(odd_entries[e].i, 3 * column + odd_entries[e].j);
      }
    }
    const MatrixXd even_numbers = product(even_kernel, even), odd_numbers = product(odd_kernel, odd);
    for (Eigen::Index m = 0; m < o.offsets; ++m) {
      double* a = result.values.data() + m * size * size;
      const auto put = [&](const Entry& entry, Eigen::Index column, double value) {
        if (column == row && entry.i < entry.j)
          return;
        a[(3 * row + entry.i) * size + 3 * column + entry.j] = value;
        a[(3 * column + entry.j) * size + 3 * row + entry.i] = parity(entry.i, entry.j) * value;
      };
      for (Eigen::Index column = 0; column < columns; ++column) {
        for (std::size_t e = 0; e < 5; ++e)
          put(even_entries[e], column, even_numbers(5 * column + static_cast<Eigen::Index>(e), m));
        for (std::size_t e = 0; e < 4; ++e)
          put(odd_entries[e], column, odd_numbers(4 * column + static_cast<Eigen::Index>(e), m));
      }
    }
  }
  return result;
}

} // namespace bem_contact
