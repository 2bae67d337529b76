#pragma once

#include "bem_contact/app/wear/wear_state.hpp"
#include "bem_contact/scene/scene_text.hpp"

#include <string>

namespace bem_contact::app {

/// A scene on a rail of sections with the profiles of this step, which lie beside it (step_file(),
/// section_file()). All else is as it was, with names of files that hold from any folder.
std::string worn_scene(const SceneText& scene, const WearState& state);

} // namespace bem_contact::app
