#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// One sentence for each cause why keys that the file gives another value than their default have no effect
/// in this combination.
std::vector<std::string> unused_keys(const SceneFile& scene, const Schema& schema);

} // namespace bem_contact
