#pragma once

#include "bem_contact/sequence/plan/model_choice.hpp"
#include "bem_contact/sequence/solution/solve_on_grid.hpp"

namespace bem_contact {

/// Answers a case on elements of the size that `grid` says: with the scene's model, or with the cheapest that
/// is predicted to be within solver.model_tolerance (model_choice.hpp). The prediction is from the estimate
/// of the contact (plane strain: from the normal problem with half-space numbers). The solution is checked by
/// the same formulas, and the case is solved again with a costlier model where they say otherwise. Influence
/// files that are not read yet are read if fem is taken. If they do not cover the contact, a warning says so,
/// and the best of the other models solves the case; a scene that names fem is refused (OffStripError).
SceneResult solve_case(const ContactCase& asked, const SceneFile::Grid& grid,
                       const SolveResources& resources);

/// The model that solve_case() tries first where the scene leaves the choice. `covered`: fem can be taken if
/// the scene names its files.
ModelChoice foreseen_model(const ContactCase& asked, bool covered);

} // namespace bem_contact
