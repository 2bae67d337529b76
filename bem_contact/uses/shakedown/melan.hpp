#pragma once

#include "bem_contact/uses/shakedown/residual_fields.hpp"

#include <vector>

namespace bem_contact::shakedown {

/// A point of the section at which the steel must not flow.
struct YieldPoint {
  DeviatorPath path;    ///< elastic stresses while the load passes, in units of k
  FieldsAtPoint fields; ///< residual stresses that it may have besides xx
};

/// The largest load that residual stresses can bear.
struct MelanLoad {
  double factor = 0; ///< of the load: the stresses nowhere exceed k up to it
  double bound = 0;  ///< no residual stress of these fields bears more
  /// Residual stress at each point under that load, in units of k.
  std::vector<Deviator> residual;
  std::vector<double> coefficients; ///< of the fields, in units of k
  std::vector<double> xx;           ///< residual stress xx at each point, in units of k
  std::vector<double> work;         ///< plastic work at each point; 1 in sum: where the limit is decided
  bool converged = false;
};

/// Melan's theorem as a cone programme:
///
///     largest factor with |factor path_ij + residual_i| <= 1 at each point i and time j
///
/// over all coefficients of the fields and xx at each point. Its dual is Koiter's theorem for these fields.
/// Both are solved together by an interior-point method with the scaling of Nesterov and Todd (Vandenberghe,
/// The CVXOPT linear and quadratic cone program solvers (2010)). xx belongs to one point alone and is
/// eliminated there.
MelanLoad largest_load(const std::vector<YieldPoint>& points, int fields);

} // namespace bem_contact::shakedown
