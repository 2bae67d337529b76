#pragma once

#include "bem_contact/sequence/scene_result.hpp"

#include <functional>
#include <vector>

namespace bem_contact {

/// Longitudinal forces at some distances from free rolling.
struct CreepForces {
  std::vector<double> creepage; ///< beyond free rolling; each model has its own creepage of free rolling
  /// These are the forces on the rail, N, and their errors by the size of the elements (nan: not known):
  /// [model][creepage].
  std::vector<std::vector<double>> Fx, Fx_error;
  bool certified = true; ///< all of them

  bool empty() const { return creepage.empty(); } ///< whether the comparison has none
};

/// One scene solved with several models, all with elements of the same size.
///
/// Results at equal forces say what a vehicle feels: forces are given, and the wheelset finds its place. Near
/// the gauge corner some hundredths of a millimetre of lateral displacement change the lateral force much,
/// and the models differ by such a shift. So at equal position most of the difference comes from it. How
/// large the shift is depends on what counts as elastic, for instance on the distance that structural =
/// "removed" means.
struct Comparison {
  std::vector<Model> models; ///< as asked for
  std::size_t reference = 0; ///< which of them the others are compared with: fem, or the last one
  /// There is one result for each model, with the same Fx (load.force_x, or 0 with friction: free rolling),
  /// Fy and Fz. Fy is load.force_y, or the reference's Fy at position.lateral. A model whose Fy there agrees
  /// within same_lateral_force stays there. Of a patch the normal force is the same. Empty for transient
  /// rolling and shifts.
  std::vector<SceneResult> at_forces;
  CreepForces creep_forces; ///< where at_forces have friction and load.force_x is not given
  /// There is one result for each model, with the same Fz, position and creepages. Empty for a patch.
  std::vector<SceneResult> at_position;

  /// Returns the results to look at first: those at equal forces, where there are some.
  const std::vector<SceneResult>& leading() const { return at_forces.empty() ? at_position : at_forces; }
};

/// Whether every result and every creep force is certified.
bool certified(const Comparison& comparison);

/// Answers a scene with the model that it names.
using SceneSolver = std::function<SceneResult(const SceneFile&)>;
/// Answers a scene at so much longitudinal creepage beyond free rolling.
using BeyondSolver = std::function<SceneResult(const SceneFile&, const FreeRolling& free, double creepage)>;

/// One scene with each of the models: at the same position, at the same forces, and beyond free rolling.
/// Throws what the solvers throw, and InputError for models or scenes that cannot be compared.
Comparison compare_models(const SceneFile& scene, std::vector<Model> models, const SceneSolver& solve,
                          const BeyondSolver& solve_beyond);

} // namespace bem_contact
