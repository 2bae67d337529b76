#pragma once

#include "bem_contact/base/error.hpp"
#include "bem_contact/uses/wheelset/wheel_pair.hpp"

#include <vector>

namespace bem_contact {

/// A wheel lifts from its rail.
class LiftError : public InputError {
public:
  using InputError::InputError; ///< as Error
};

/// What a search for an equilibrium begins with.
struct EquilibriumStart {
  double right = 0, left = 0;           ///< approach of each wheel, mm
  double roll = 0;                      ///< rad: near it
  std::optional<double> rolling_radius; ///< mm: near it; empty: it is not looked for
};

/// Height and roll at which both wheels have these approaches, as rigid bodies: 0 means that they touch.
WheelsetPose stand(WheelPair& wheels, double lateral, const EquilibriumStart& start);

/// A wheelset that stands.
struct Equilibrium {
  WheelsetState state;
  /// Largest residual: sums of forces over the vertical force, moments over that times their lever arm.
  double residual = 0;
  int evaluations = 0;       ///< poses at which both wheels were solved
  std::vector<double> slope; ///< of the equations over their unknowns, by the last steps; column by column

  /// To begin the search at a neighbouring lateral displacement.
  EquilibriumStart start() const;
};

/// Height and roll of the wheelset at one lateral displacement, so that the sum of the vertical forces is
/// wheelset.force and the moment about the forward axis through its centre is wheelset.roll_moment; and, if
/// start.rolling_radius is given, that radius, so that wheelset.torque drives the axle.
///
/// Newton's steps with a model of the stiffness: each patch keeps the direction of its force, whose size
/// grows with the approach as Hertz's law has it; longitudinal forces grow with creepage as Kalker's and
/// Vermeulen and Johnson's do. Broyden's updates (1965) then make the matrix that of the contacts. Steps are
/// bounded and halved; where that does not help, the matrix is computed by differences, once.
///
/// Throws LiftError if one wheel lifts, InputError for a torque that friction cannot bear, ConvergenceError
/// if no equilibrium was found.
Equilibrium find_equilibrium(WheelPair& wheels, double lateral, const EquilibriumStart& start,
                             double tolerance);
/// The same from a pose and the slope of the equations there. `solved`: both wheels at this pose; null: they
/// are not solved yet.
Equilibrium find_equilibrium(WheelPair& wheels, const WheelsetPose& first, double tolerance,
                             const std::vector<double>& slope, const WheelsetState* solved = nullptr);

} // namespace bem_contact
