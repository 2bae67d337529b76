#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"

#include <memory>

namespace bem_contact {

class SequenceFiles;

/// Files that several sequences of one thread share. They are read when a scene first asks for them.
std::shared_ptr<SequenceFiles> shared_files();

/// The profiles of a scene of a wheel on a rail, read now unless they are known. Throws InputError for
/// profiles that cannot be read.
WheelRailProfiles read_profiles(const SceneFile& scene, SequenceFiles& files);

} // namespace bem_contact
