#include "bem_contact/influence/remote_factor.hpp"

#include "bem_contact/base/error.hpp"

#include <Eigen/Cholesky>

#include <string>

namespace bem_contact {

namespace {

/// 1. Reciprocal condition of the remote section's compliance, scaled to a unit diagonal, below which the
/// structure is not removed: its inverse would have no correct digits.
constexpr double least_remote_condition = 1e-13;

} // namespace

RowMajor remote_factor(const InfluenceStrip& f, StationRange range, Eigen::Index k) {
  using Table = Eigen::Map<const RowMajor>;
  const auto n = static_cast<Eigen::Index>(3 * f.station_count());
  Eigen::Matrix<double, 6, 6> self = Table(f.remote_self.data() + k * 36, 6, 6);
  // Displacements and rotations differ in unit: scale to a unit diagonal before the factorization.
  const Eigen::Matrix<double, 6, 1> diagonal = self.diagonal();
  if (diagonal.minCoeff() > 0) {
    const Eigen::Matrix<double, 6, 1> scale = diagonal.cwiseSqrt().cwiseInverse();
    self = scale.asDiagonal() * self * scale.asDiagonal();
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> cholesky(self);
    if (cholesky.info() == Eigen::Success && cholesky.rcond() > least_remote_condition) {
      RowMajor factor = scale.asDiagonal() *
                        Table(f.remote.data() + k * 6 * n, 6, n).middleCols(3 * range.first, 3 * range.count);
      cholesky.matrixL().solveInPlace(factor);
      return factor;
    }
  }
  throw InputError("The structural compliance of '" + f.body + "' cannot be removed",
                   "the remote section's own compliance is not positive definite at wavenumber " +
                       std::to_string(f.wavenumber[static_cast<std::size_t>(k)]) + " 1/mm",
                   "Use structural compliance 'included', or compute the file again.");
}

} // namespace bem_contact
