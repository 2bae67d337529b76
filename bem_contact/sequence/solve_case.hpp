#pragma once

#include "bem_contact/sequence/solve_on_grid.hpp"

namespace bem_contact {

/// Answers a case on elements of the size that `grid` says: with the scene's model, or with the cheapest
/// whose predicted error of pmax is within solver.model_tolerance (model_choice.hpp): hertz by a fit of the
/// undeformed distance, the others by the turn of the normal within the contact that the normal problem has
/// with half-space numbers; fem only where there are influence files.
SceneResult solve_case(const ContactCase& asked, const SceneFile::Grid& grid,
                       const SolveResources& resources);

} // namespace bem_contact
