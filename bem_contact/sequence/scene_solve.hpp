#pragma once

#include "bem_contact/sequence/hertz_model.hpp"
#include "bem_contact/sequence/scene_stage.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// Nothing where the problem is not one of Hertz's.
std::optional<HertzModel> hertz_of(const Stage& stage);

/// Solves the problem on the grid as it is. Without `tangential` it is a look at the normal problem, for the
/// choice of the model.
SceneResult solve_once(Stage& stage, Model model, bool tangential);

} // namespace bem_contact
