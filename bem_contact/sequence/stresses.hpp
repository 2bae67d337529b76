#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <vector>

namespace bem_contact {

/// Stresses in the rail (patch: in the lower body) at the points asked for. [x][s][depth], depth fastest.
struct StressesBelow {
  std::vector<double> x, s, depths;      ///< mm; s on the rail's arc length, depth along n
  std::vector<halfspace::Stress> stress; ///< frame (x, s, n) of the point's own row, MPa, tension positive
  std::vector<double> von_mises, largest_shear; ///< MPa
};

/// Sums the closed forms of the half-space over the tractions of `result`. Distances are taken along the arc,
/// as if the strip were unrolled into a plane: exact where it is flat. In plane strain elements are endless
/// along x. asked.s is relative to `reference_s`. Throws InputError for more than a million points.
StressesBelow stresses_below(const SceneFile::Stresses& asked, const ContactProblem& problem,
                             const ContactResult& result, double poisson, double reference_s);

} // namespace bem_contact
