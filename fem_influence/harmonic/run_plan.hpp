#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <optional>
#include <span>
#include <vector>

namespace bem_contact::fem {

/// Where the kernel is sampled (THEORY.md, 7): k = n pi / L for n = 0 .. 8 with L = half_period, then equal
/// steps in log k, at least `samples_per_decade` a decade and an even number of them, up to and with k_max =
/// 10 / shortest_dx. 1/mm, ascending, the first is 0; lengths in mm. Throws InputError where the harmonics
/// reach beyond k_max.
std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade);

/// One wavenumber of the run or of its companion.
struct WavenumberTask {
  bool companion = false;
  std::size_t k = 0; ///< place in the wavenumbers of the run, or of the companion
};

/// The companion: a run that is coarser in everything and says how wrong the run is (error_estimate.hpp).
struct CompanionPlan {
  BodyFile body;                     ///< with one degree and one level less
  std::vector<std::size_t> stations; ///< of the run's, which it computes alone
  InfluenceFunction function;        ///< described, without kernel
};

/// What a run computes. It follows from the body file alone, so every process has the same.
struct RunPlan {
  InfluenceFunction function;             ///< described, without kernel
  std::optional<CompanionPlan> companion; ///< none at degree 1, which has no coarser degree
  std::vector<WavenumberTask> tasks;      ///< the run's, then the companion's

  double wavenumber(const WavenumberTask& task) const; ///< 1/mm
};

/// Throws InputError for a strip or wavenumbers that cannot be.
RunPlan plan_run(const BodyFile& body, const ProfileCurve& curve);

/// shortest_dx as arc length at the reference radius, mm: an element at the strip's largest radius is the
/// shortest there.
double shortest_reference_dx(const BodyFile& body, std::span<const Station> stations);

} // namespace bem_contact::fem
