#pragma once

#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"
#include "fem_influence/harmonic/error_estimate.hpp"
#include "fem_influence/harmonic/meshed_system.hpp"

#include <filesystem>
#include <functional>

namespace bem_contact::fem {

struct RunReport {
  std::size_t cells = 0, unknowns = 0, stations = 0, wavenumbers = 0, companion_wavenumbers = 0;
  std::size_t resumed = 0; ///< wavenumbers of both found in the partial files
  Timing timing;           ///< sum over the processes
  double seconds = 0;      ///< wall clock
  double peak_memory = 0;  ///< of the largest process, GiB
  double betti_error = 0, reaction_error = 0;
  double smallest_eigenvalue = 0; ///< of the kernel, over its largest diagonal entry
  ErrorEstimate error;            ///< 0: not estimated (degree 1)
};

/// Called on the first process at the start and whenever a wavenumber is finished; the companion's count.
using RunProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Computes a body's influence function, and a coarser companion that says how wrong it is, and writes it to
/// `output`: wavenumbers are spread over the MPI processes and collected by the first, which keeps the
/// finished ones in partial files, so that a run that was killed goes on where it stopped. The file does not
/// depend on the number of processes. Called by all processes together; the report is complete on the first.
/// Throws InputError for a mesh or a strip that does not fit, and for an output that cannot be written.
RunReport run_harmonic(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh,
                       const std::filesystem::path& output, const RunProgress& progress = {});

} // namespace bem_contact::fem
