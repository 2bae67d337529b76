#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: checks across keys.
namespace bem_contact {

/// Throws InputError, naming line and key, for keys that exclude each other and for one that is missing.
void check_keys(const SceneFile& scene, const Schema& schema);

} // namespace bem_contact
