#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/influence/stress_kernel.hpp"
#include "bem_contact/inside/stresses_inside.hpp"

#include <filesystem>
#include <span>

namespace bem_contact::inside {

/// Adds the body's stresses, by the stress kernel of its influence file, to those of the half-space under the
/// same tractions. Nothing is solved for: sums over the kernel's wavenumbers of left (right^T tractions). The
/// error of each point is what the kernel says of the mesh, and what the way to the surface may be off;
/// points beside or below those of the kernel are nan. Throws InputError where tractions leave the strip, and
/// for points of one's own that the kernel does not reach.
void add_stresses_by_file(StressesInside& stresses, const SurfaceTractions& tractions,
                          const InfluenceStrip& strip, const StressKernel& kernel);

/// An influence file that has stresses. Several threads may look at one.
struct FileOfStresses {
  InfluenceStrip strip;
  StressKernel kernel;

  /// Throws what InfluenceFile does, and InputError that names the commands that make stresses, where there
  /// are none.
  explicit FileOfStresses(const std::filesystem::path& file);
};

/// The stresses of a result inside this body, with those of the half-space beside them. Throws InputError for
/// the body of another result, and as above.
StressesInside stresses_by_file(const record::Record& result, const FileOfStresses& file,
                                std::span<const BelowSurface> own = {});

} // namespace bem_contact::inside
