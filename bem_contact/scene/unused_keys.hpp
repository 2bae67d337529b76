#pragma once

#include "bem_contact/base/schema.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Keys that the file sets to another value than their default, and that have no effect in this combination:
/// one sentence for each reason.
std::vector<std::string> unused_keys(const SceneFile& scene, const Schema& schema);

} // namespace bem_contact
