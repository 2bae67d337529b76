#pragma once

#include "bem_contact/contact/result.hpp"
#include "bem_contact/halfspace/stress.hpp"
#include "bem_contact/inside/stresses_by_file.hpp"
#include "bem_contact/inside/surface_tractions.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <span>
#include <string>
#include <vector>

namespace bem_contact {

/// Tensors at points, and their measures; [x][s][depth], depth fastest.
struct StressField {
  std::vector<halfspace::Stress> stress; ///< frame (x, s, n) of the surface above, MPa, tension positive
  std::vector<double> von_mises, largest_shear; ///< MPa

  /// Adds the next point.
  void add(const halfspace::Stress& stress);
};

/// Stresses in one of the two real bodies, and those of a half-space at the same points.
struct StressesInBody {
  inside::Side side = inside::Side::rail; ///< which of the two
  std::string body;                       ///< its name
  std::vector<double> s;                  ///< of the points on the body's own profile, mm
  StressField in_body;                    ///< of the real body
  StressField halfspace;                  ///< of a half-space
  std::vector<double> error;              ///< of the body's solution, as von Mises' stress, MPa; [s][depth]
};

/// Stresses of a half-space in the rail (patch: in the lower body) at the points asked for.
struct StressesBelow : StressField {
  std::vector<double> x, s, depths;   ///< mm; s on the rail's arc length, depth along n
  std::vector<StressesInBody> bodies; ///< where they are asked for; of the wheel at the points opposite
};

/// The tractions of a solution on the lower body (rail), on its rows; in plane strain on very long elements.
inside::SurfaceTractions surface_tractions(const ContactProblem& problem, const ContactResult& result,
                                           double poisson);

/// Sums the closed forms of the half-space over the tractions. Distances are taken along the arc, as if the
/// strip were unrolled into a plane: exact where it is flat. asked.s is relative to `reference_s`. Throws
/// InputError for more than a million points.
StressesBelow stresses_below(const SceneFile::Stresses& asked, const inside::SurfaceTractions& tractions,
                             double reference_s);

/// Those in the body of an influence file under its own tractions, below these places x and s of its profile
/// (mm). Throws InputError for points that the file does not reach.
StressesInBody stresses_in_body(const SceneFile::Stresses& asked, std::vector<double> s,
                                const inside::SurfaceTractions& tractions, inside::Side side,
                                const inside::FileOfStresses& file);

} // namespace bem_contact
