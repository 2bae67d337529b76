#pragma once

#include "bem_contact/sequence/plan/contact_case.hpp"
#include "bem_contact/sequence/scene_description.hpp"

namespace bem_contact {

/// Throws InputError where the grid that is asked for cannot be.
SceneDescription describe_case(const ContactCase& asked);

} // namespace bem_contact
