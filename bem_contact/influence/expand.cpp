#include "bem_contact/influence/expand.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <string>

namespace bem_contact {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Table = Eigen::Map<const RowMajor>;
using Strided = Eigen::Stride<Eigen::Dynamic, Eigen::Dynamic>;

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

/// The kernel of wavenumber k on the range, with the remote section's mean motion taken out if so wanted.
RowMajor kernel_on(const InfluenceFunction& f, StationRange range, StructuralCompliance structural,
                   Eigen::Index k) {
  const auto n = static_cast<Eigen::Index>(3 * f.station_count());
  const Eigen::Index from = 3 * range.first, size = 3 * range.count;
  RowMajor g = Table(f.kernel.data() + k * n * n, n, n).block(from, from, size, size);
  if (structural == StructuralCompliance::included)
    return g;
  const RowMajor remote = Table(f.remote.data() + k * 6 * n, 6, n).middleCols(from, size);
  Eigen::Matrix<double, 6, 6> self = Table(f.remote_self.data() + k * 36, 6, 6);
  // Displacements and rotations differ in unit: scale to a unit diagonal before the factorization.
  const Eigen::Matrix<double, 6, 1> diagonal = self.diagonal();
  bool definite = diagonal.minCoeff() > 0;
  if (definite) {
    const Eigen::Matrix<double, 6, 1> scale = diagonal.cwiseSqrt().cwiseInverse();
    self = scale.asDiagonal() * self * scale.asDiagonal();
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> factor(self);
    definite = factor.info() == Eigen::Success && factor.rcond() > 1e-13;
    if (definite) {
      RowMajor half = scale.asDiagonal() * remote;
      factor.matrixL().solveInPlace(half);
      // rankUpdate fills one triangle: the result stays symmetric to the last bit.
      RowMajor update = RowMajor::Zero(size, size);
      update.selfadjointView<Eigen::Lower>().rankUpdate(half.transpose());
      g -= RowMajor(update.selfadjointView<Eigen::Lower>());
    }
  }
  if (!definite)
    throw InputError("the structural compliance of '" + f.body + "' cannot be removed",
                     "the remote section's own compliance is not positive definite at wavenumber " +
                         std::to_string(f.wavenumber[static_cast<std::size_t>(k)]) + " 1/mm",
                     "use structural compliance 'included', or compute the file again");
  return g;
}

} // namespace

InfluenceNumbers expand(const InfluenceFunction& f, const ExpandOptions& o) {
  const StationRange range = checked_range(f, o);
  const Scaling scaling = checked_scaling(f, o);
  const Eigen::Index size = 3 * range.count;
  InfluenceNumbers result{o.offsets, static_cast<int>(range.count), o.dx, f.station_width, {}};
  result.values.assign(static_cast<std::size_t>(o.offsets * size * size), 0.0);

  if (o.dx == 0) {
    const RowMajor g = kernel_on(f, range, o.structural, 0);
    for (int row = 0; row < size; ++row)
      for (int column = 0; column < size; ++column)
        if (parity(row % 3, column % 3) > 0) // odd ones vanish at k = 0
          result.values[static_cast<std::size_t>(row * size + column)] = scaling.load * g(row, column);
    return result;
  }

  const auto nk = static_cast<Eigen::Index>(f.wavenumber_count());
  RowMajor kernel(nk, size * size);
  for (Eigen::Index k = 0; k < nk; ++k)
    kernel.row(k) = kernel_on(f, range, o.structural, k).reshaped<Eigen::RowMajor>().transpose();

  const SeriesWeights weights = series_weights(f.wavenumber, f.half_period, scaling.dx, o.offsets);
  const RowMajor even = scaling.load * Table(weights.even.data(), o.offsets, nk);
  const RowMajor odd = scaling.load * Table(weights.odd.data(), o.offsets, nk);
  // The columns J <= I alone; the others by Maxwell-Betti, which keeps it exact.
  for (Eigen::Index row = 0; row < size; ++row)
    for (Eigen::Index j = 0; j < 3; ++j) {
      const auto i = static_cast<int>(row % 3);
      const Eigen::Index start = row * size + j, columns = row / 3 + 1;
      const Eigen::Map<const RowMajor, 0, Strided> g(kernel.data() + start, nk, columns,
                                                     Strided(size * size, 3));
      Eigen::Map<RowMajor, 0, Strided> to(result.values.data() + start, o.offsets, columns,
                                          Strided(size * size, 3));
      if (parity(i, static_cast<int>(j)) > 0)
        to.noalias() = even * g;
      else if (i == component_x)
        to.noalias() = odd * g; // load p_j cos kx: u_x = +g_xj sin kx
      else
        to.noalias() = -(odd * g); // load p_x cos kx: u_i = -g_ix sin kx
    }
  for (int m = 0; m < o.offsets; ++m) {
    double* a = result.values.data() + m * size * size;
    for (Eigen::Index row = 0; row < size; ++row)
      for (Eigen::Index column = 0; column < row; ++column)
        a[column * size + row] =
            parity(static_cast<int>(row % 3), static_cast<int>(column % 3)) * a[row * size + column];
  }
  return result;
}

} // namespace bem_contact
