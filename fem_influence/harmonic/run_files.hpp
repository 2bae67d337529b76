#pragma once

#include "bem_contact/influence/partial_influence_file.hpp"
#include "fem_influence/harmonic/harmonic_solver.hpp"
#include "fem_influence/harmonic/run_plan.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact::fem {

/// Hash of all that the numbers of a run depend on: finished wavenumbers of another run are not taken over.
std::string fingerprint(const BodyFile& body, const ProfileCurve& curve, const std::filesystem::path& mesh);

/// A wavenumber's numbers as PartialInfluenceFile takes them, to be sent to the first process.
std::vector<double> packed(const WavenumberResult& result);

/// The errors of all wavenumbers of a run in one.
struct KernelErrors {
  double betti = 0, reaction = 0; ///< largest
  double smallest_eigenvalue = 0; ///< smallest
};

/// The finished wavenumbers of a run and of its companion, on disk until the influence file is complete: a
/// run that was killed goes on where it stopped. On the first process alone.
class RunFiles {
public:
  /// Opens or creates OUTPUT.part and OUTPUT.companion.part. Throws InputError if they hold finished
  /// wavenumbers of another fingerprint.
  RunFiles(const std::filesystem::path& output, const std::string& fingerprint, const RunPlan& plan);

  bool has(const WavenumberTask& task) const;
  void write(const WavenumberTask& task, std::vector<double> packed);
  /// Puts all kernels into the plan's functions; the files keep the errors alone. All wavenumbers must be
  /// there.
  KernelErrors take_into(RunPlan& plan);
  void remove();

private:
  PartialInfluenceFile run_;
  std::optional<PartialInfluenceFile> companion_;
};

} // namespace bem_contact::fem
