#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <string>
#include <vector>

/// Private to this room: checks across keys.
namespace bem_contact {

/// Throws InputError, naming line and key, for keys that exclude each other and for one that is missing.
void check_keys(const SceneFile& scene, const Schema& schema);

/// Keys that the file sets to another value than their default, and that have no effect in this combination:
/// one sentence for each reason.
std::vector<std::string> unused_keys(const SceneFile& scene, const Schema& schema);

} // namespace bem_contact
