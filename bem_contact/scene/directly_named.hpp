#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <vector>

namespace bem_contact {

/// What the keys of a scene name, table by table. No file is read: what body files name is not among them
/// (named_files() has it too).
std::vector<NamedFile> directly_named(const SceneFile& scene);

} // namespace bem_contact
