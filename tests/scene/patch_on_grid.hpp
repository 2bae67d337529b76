#pragma once

#include "bem_contact/scene/contact_setup.hpp"

namespace bem_contact {

/// The contact of a `patch` scene on its own grid.
inline ContactOnGrid patch_on_grid(const SceneFile& scene) {
  const ContactSetup setup = set_up_patch(scene);
  return setup.on(setup.patch()->plan());
}

} // namespace bem_contact
