#pragma once

#include "bem_contact/scene/scene_file.hpp"

/// Private to this room: every key of a scene, with its unit, range and a line of explanation.
namespace bem_contact {

/// As read, before they become shear moduli.
struct YoungsModuli {
  double rail = 0, wheel = 0;
};

/// Reads into `file` and `young`, which must outlive it.
Schema scene_schema(SceneFile& file, YoungsModuli& young);

} // namespace bem_contact
