#pragma once

#include "bem_contact/scene/scene_file.hpp"

namespace bem_contact {

/// What belongs to a scene with a table [wheelset] and what does not. Throws InputError, naming line and key,
/// for a load or a position of one wheel, and for [wheelset] without its vertical force.
void check_wheelset(const SceneFile& file, const Schema& schema);

} // namespace bem_contact
