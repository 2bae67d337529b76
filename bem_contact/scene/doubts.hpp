#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Sentences on what can be solved but is hardly meant: another unit, a diameter for a radius, a wheel that
/// stands on its flange. `placed`: null for a patch.
std::vector<std::string> doubts(const SceneFile& scene, const WheelRailScene* placed);

} // namespace bem_contact
