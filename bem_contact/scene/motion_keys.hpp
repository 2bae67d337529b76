#pragma once

#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: the keys of motion, friction and heat.
namespace bem_contact {

void add_motion(Schema& s, SceneFile::Motion& m);           ///< [motion]
void add_temperature(Schema& s, SceneFile::Temperature& t); ///< [temperature]

} // namespace bem_contact
