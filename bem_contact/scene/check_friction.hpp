#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/scene/scene_file.hpp"

namespace bem_contact {

/// Keys of friction that depends on slip, slip velocity or temperature, and of [temperature]. Throws
/// InputError where they exclude each other or one is missing.
void check_friction(const SceneFile& file, const Schema& schema);

} // namespace bem_contact
