#pragma once

#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: every key of a scene, with its unit, range and a line of explanation.
namespace bem_contact {

/// Values of keys that have no member of their own in SceneFile; settle() turns them into one.
struct SceneKeysAsRead {
  double rail_young = 0, wheel_young = 0; ///< MPa; else the shear modulus
  double s_from = 0, s_to = 0;            ///< mm; both 0: no rows are asked for
};

/// Reads into `file` and `read`, which must outlive it.
Schema scene_schema(SceneFile& file, SceneKeysAsRead& read);

/// After reading: sets shear moduli and rows. Throws InputError if a material has two moduli.
void settle(SceneFile& file, const Schema& schema, const SceneKeysAsRead& read);

} // namespace bem_contact
