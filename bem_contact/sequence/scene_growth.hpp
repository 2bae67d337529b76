#pragma once

#include "bem_contact/sequence/scene_stage.hpp"

namespace bem_contact {

constexpr int most_growths = 6;

/// Solves on a grid that grows until the contact lies inside and no second area would overlap outside (a
/// patch: says so). Without `tangential` it is a look at the normal problem, for the choice of the model.
/// Throws InputError where the strips of influence files end before, or the grid would grow more than
/// most_growths times.
SceneResult solve_grown(Stage& stage, Model model, bool tangential);

} // namespace bem_contact
