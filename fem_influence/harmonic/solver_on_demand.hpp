#pragma once

#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"

#include <functional>
#include <optional>

namespace bem_contact::fem {

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
