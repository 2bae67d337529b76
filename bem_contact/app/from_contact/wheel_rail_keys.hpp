#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/contact_input/blocks.hpp"

#include <filesystem>

namespace bem_contact::app::from_contact {

/// A case of module 1 as keys of a scene. `folder`: where the profiles are looked for.
void add_wheel_rail_keys(const contact_input::CaseState& state, const std::filesystem::path& folder,
                         ContactCase& out);

} // namespace bem_contact::app::from_contact
