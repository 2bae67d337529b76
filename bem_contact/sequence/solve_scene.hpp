#pragma once

#include "bem_contact/contact/history.hpp"
#include "bem_contact/contact/problem.hpp"
#include "bem_contact/contact/solve.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/model_choice.hpp"
#include "bem_contact/sequence/stresses.hpp"

#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// Wall-clock seconds by phase.
struct PhaseSeconds {
  double geometry = 0; ///< files, profiles, contact search, undeformed distance
  double numbers = 0;  ///< influence numbers
  double solve = 0;
  double total = 0;
};

/// One scene solved with one model.
struct SceneResult {
  Model model = Model::halfspace;
  std::string reason;     ///< why this model, in a sentence
  ContactProblem problem; ///< grid, rows (wheel_rail: track frame), undeformed distance, rigid slip; values
                          ///< of the numbers left out
  ContactResult result;   ///< of the last step
  std::vector<ContactResult> history; ///< transient and shift: of every step
  Displacements displacements;        ///< of the last step
  ReferencePoint reference;
  bool left = false;           ///< left wheel: y and s are counted to the left (placement.hpp)
  double moment = 0;           ///< Mz about the vertical axis through the reference point, N mm
  std::vector<double> wheel_s; ///< station on the upper body of each row, mm; empty where it has none
  std::vector<Point2> rail_profile, wheel_profile; ///< near the contact at approach 0, frame of the rows, mm
  std::optional<StressesBelow> stresses;           ///< where the scene asks for them
  std::vector<std::string> warnings;
  PhaseSeconds seconds;
};

/// Both models at equal vertical force (a prescribed approach is turned into the force that fem finds for
/// it).
struct Comparison {
  SceneResult halfspace, fem;
};

/// Without a model in the scene, takes the cheapest whose predicted error of pmax is within
/// solver.model_tolerance (model_choice.hpp): hertz by a fit of the undeformed distance, the others by the
/// turn of the normal within the contact that the normal problem has with half-space numbers; fem only where
/// there are influence files. A wheel_rail grid grows until the contact lies inside; throws InputError where
/// the strip of an influence file ends before. Throws InputError for wrong input; lack of convergence is in
/// the result.
SceneResult solve_scene(const SceneFile& scene);
Comparison compare_scene(const SceneFile& scene);

/// What would be solved, line by line, after everything short of the solve has been checked.
/// Throws what solve_scene would throw.
std::vector<std::string> check_scene(const SceneFile& scene);

} // namespace bem_contact
