#pragma once

#include "fem_influence/harmonic_solver.hpp"

#include <filesystem>
#include <functional>

namespace bem_contact::fem {

struct RunReport {
  std::size_t cells = 0, unknowns = 0, stations = 0, wavenumbers = 0;
  std::size_t resumed = 0; ///< wavenumbers found in the partial file
  Timing timing;           ///< sum over the processes
  double seconds = 0;      ///< wall clock
  double peak_memory = 0;  ///< of the largest process, GiB
  double betti_error = 0, reaction_error = 0;
  double interpolation_error = 0, discretisation_error = 0; ///< -1: not estimated
};

/// Called on the first process at the start and after each round of wavenumbers.
using RunProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Computes a body's influence function and writes it to `output`: one wavenumber at a time on each MPI
/// process, collected by the first, which keeps the finished ones in a partial file, so that a run that was
/// killed goes on where it stopped. The file does not depend on the number of processes. Called by all
/// processes together; the report is complete on the first.
/// Throws InputError for a mesh or a strip that does not fit, and for an output that cannot be written.
RunReport run_harmonic(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                       const std::filesystem::path& output, const RunProgress& progress = {});

/// Error of the kernel by the mesh at one wavenumber, against a companion of one degree less on the same
/// mesh. Errors of displacements averaged over a station go as (h / p^2)^2 (FEM_NOTES: Q2, Q3), so that the
/// difference of p - 1 and p is ((p / (p-1))^4 - 1) times the error of p. Relative to the self numbers.
/// -1 for degree 1.
double discretisation_error(const std::filesystem::path& mesh, const BodyFile& body,
                            const ProfileCurve& curve, double wavenumber, std::span<const double> kernel);

} // namespace bem_contact::fem
