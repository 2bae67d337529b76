#pragma once

#include "bem_contact/uses/wheelset/curve.hpp"
#include "bem_contact/uses/wheelset/wheel_pair.hpp"

#include <atomic>
#include <string>
#include <vector>

namespace bem_contact {

/// Both wheels of a wheelset in equilibrium.
///
/// The forces on the axle are given: wheelset.force down (normal to the track), and wheelset.force_y to the
/// right, with the force of a curve (CurveDemand), or, instead, the lateral displacement. Both act at the
/// wheelset's centre, on the axle. Roll follows from the moments about the forward axis through that centre:
/// each vertical force on a rail has the lever arm y of its contact (some 750 mm), each lateral force the
/// height of the axle above it (some 460 mm), and their sum is wheelset.roll_moment. Yaw is given. The axle
/// turns both wheels alike: the rolling radius is given, or is that at which wheelset.torque drives the axle
/// (0: it rolls freely).
struct WheelsetResult {
  WheelsetState state;    ///< where it stands, and both wheels
  double residual = 0;    ///< largest of the equilibrium's (Equilibrium::residual)
  CurveDemand curve = {}; ///< nan on straight track
  /// |sum Fy - force_y - curve.force| over force; nan where the displacement is given.
  double lateral_residual = std::numeric_limits<double>::quiet_NaN();
  /// By how much the lateral displacement that was found may be off, because forces are off by their stated
  /// errors, mm; where these are not known, by what larger elements change. nan: the displacement is given.
  double lateral_error = std::numeric_limits<double>::quiet_NaN();
  int contact_problems = 0; ///< solved on the way, both wheels
  Warnings warnings = {};   ///< of both wheels
  double seconds = 0;       ///< of the call
};

/// Both wheels where the search for the equilibrium begins: at position.lateral, each with the approach of
/// about half of the vertical force.
struct WheelsetDescription {
  double lateral = 0, roll = 0; ///< mm; rad
  SceneDescription right;       ///< the wheel to the right of the rolling direction, as asked
  SceneDescription left;        ///< the other one, y and s to the left
  Warnings warnings = {};       ///< of the wheelset, beside those of either wheel
};
/// Solves no equilibrium. Throws what solve_wheelset() would throw before it solves.
WheelsetDescription check_wheelset(const SceneFile& scene);
/// What can be said of any scene before it is solved: Sequence::check(), and of a wheelset all lines of both
/// wheels and each warning once.
SceneDescription describe_scene(const SceneFile& scene);

/// Throws InputError for a scene without [wheelset], wrong input, a wheel that lifts, and a lateral force
/// that no displacement gives; ConvergenceError where no equilibrium was found. `stop`: as Sequence::solve().
/// `files`: what earlier calls have read; null: nothing.
WheelsetResult solve_wheelset(const SceneFile& scene, const std::atomic<bool>* stop = nullptr,
                              std::shared_ptr<SequenceFiles> files = nullptr);

} // namespace bem_contact
