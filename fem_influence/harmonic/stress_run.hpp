#pragma once

#include "fem_influence/harmonic/stress_solver.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace bem_contact::fem {

/// The finished wavenumbers of stresses lie in this file beside the output until all is complete.
std::filesystem::path partial_stresses(const std::filesystem::path& output);

/// Computes the stresses of the inside: wavenumbers are spread over the processes and collected by the first,
/// which keeps the finished ones in partial_stresses(), so that a run that was killed goes on. Called by all
/// processes together; the kernel is complete on the first. `fingerprint`: of all that the numbers depend on.
StressKernel run_stresses(const StressPlan& plan, const ProfileCurve& curve,
                          const std::filesystem::path& mesh, const std::filesystem::path& output,
                          const std::string& fingerprint,
                          const std::function<void(std::size_t done)>& progress);

} // namespace bem_contact::fem
