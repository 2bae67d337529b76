#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <limits>

namespace bem_contact {

/// What a curve asks of a wheelset. nan: straight track.
struct CurveDemand {
  /// Lateral force on the axle, N, to the right: what superelevation leaves of the centrifugal force.
  double force = std::numeric_limits<double>::quiet_NaN();
  /// Difference of the rolling radii, right less left, mm, at which neither wheel would creep along x.
  double radius_difference = std::numeric_limits<double>::quiet_NaN();
};

/// The force is wheelset.force (v^2 / (g R) - superelevation / base), outwards, the difference wheel_radius
/// base / R: the outer wheel has the longer way. A small angle of the track is taken for its sine.
CurveDemand curve_demand(const SceneFile& scene);

/// The scene with wheelset.force_y, if it is given, as all that presses the axle to the side: with the
/// curve's.
SceneFile with_curve_force(SceneFile scene);

} // namespace bem_contact
