#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/contact_input/blocks.hpp"

namespace bem_contact::app::from_contact {

/// A case of module 3 as keys and tables of a scene.
void add_patch_keys(const contact_input::CaseState& state, ContactCase& out);

} // namespace bem_contact::app::from_contact
