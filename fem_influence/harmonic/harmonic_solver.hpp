#pragma once

#include "fem_influence/harmonic/harmonic_system.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"
#include "fem_influence/shared/mumps_solver.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// What one wavenumber gives; layout as in InfluenceFunction.
struct WavenumberResult {
  std::vector<double> kernel;      ///< 3NS x 3NS, symmetric to the last bit
  std::vector<double> remote;      ///< 6 x 3NS
  std::vector<double> remote_self; ///< 6 x 6
  double betti_error = 0;          ///< largest |g_ab - g_ba| / sqrt(g_aa g_bb): the two are computed as one
  double smallest_eigenvalue = 0;  ///< of the kernel, over its largest diagonal entry
  double reaction_error = 0;       ///< at k = 0: largest |reaction + load| / load over the rigid motions
};

/// Of a symmetric matrix, over its largest diagonal entry: positive when every traction does positive work.
/// By Cholesky factors and inverse iteration; 0 where there are no such factors.
double smallest_eigenvalue(std::span<const double> kernel);

/// K(k) of the cells as MumpsSolver takes it, into `value`.
void evaluate(const HarmonicSystem& system, double k, std::vector<double>& value);

/// The section's problem for any wavenumber: with F the stations' functionals and r the remote ones,
///     kernel = F^T K^-1 F / ds, remote = r^T K^-1 F, remote_self = ds r^T K^-1 r.
/// The unit generalised load of remote_self is ds times a unit, as a unit traction on a station is: so
/// kernel - remote^T remote_self^-1 remote is the kernel with the six means of the remote section held at 0.
class HarmonicSolver {
public:
  /// The matrix's pattern is analysed here, once for all wavenumbers. `order`: of elimination, as
  /// elimination_order() gives it; empty: it is found here.
  explicit HarmonicSolver(HarmonicSystem system, std::span<const int> order = {});

  /// Wavenumber in 1/mm. Throws as MumpsSolver::factorize() does.
  WavenumberResult at(double wavenumber);

private:
  HarmonicSystem system_;
  MumpsSolver solver_;
  std::vector<double> value_;
};

/// The solver of the run or of its companion as one process sees it: made for the first wavenumber that the
/// process does, and freed by release() after the last.
class SolverOnDemand {
public:
  /// `assemble` gives the matrices when they are needed. `timing` must live as long.
  SolverOnDemand(std::function<AssembledSystem()> assemble, Timing& timing);

  WavenumberResult at(double wavenumber);
  void release() { solver_.reset(); }

private:
  std::function<AssembledSystem()> assemble_;
  Timing& timing_;
  std::optional<HarmonicSolver> solver_;
};

} // namespace bem_contact::fem
