#pragma once

#include "bem_contact/uses/curves/creep_curves.hpp"

#include <functional>

namespace bem_contact {

/// Where derivatives are taken.
struct DerivativePlace {
  Creepages at{};
  Creepages steps{}; ///< of differences
  /// Of the leading error of a difference in its step, which two steps take out. 2 where forces are smooth.
  /// At zero creepage slip begins at both sides of zero, and the error has order 1.
  int order = 2;
};

/// Whose derivatives they are.
struct DerivedContact {
  const SceneFile& scene; ///< as given
  HeldContact held;
  int elements = 0; ///< in contact
};

/// Who solves.
struct CreepSolvers {
  CreepSolver points; ///< of the scene
  /// One point of a scene that names derivatives.
  std::function<CreepPoint(const SceneFile& scene, const HeldContact& held, const Creepages& at)> with_slopes;
};

/// Nine derivatives of the forces by the creepages: of the solution at this place and of one on elements
/// twice as large. Where these have none, or bend: differences of twelve solutions, and of six on elements
/// twice as large.
CreepDerivatives creep_derivatives(const DerivedContact& contact, const DerivativePlace& place,
                                   const CreepSolvers& solvers);

} // namespace bem_contact
