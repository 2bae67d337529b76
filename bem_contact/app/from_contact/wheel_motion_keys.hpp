#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"
#include "bem_contact/contact_input/blocks.hpp"

namespace bem_contact::app::from_contact {

/// How wheelset and wheel of module 1 move, as keys. A step of T = 1 in which the wheelset turns is one of
/// transient rolling.
void add_velocity(const contact_input::CaseState& state, ContactCase& out);

/// Whether the rail is a roller (C1 = 4, 5).
bool on_roller(const contact_input::CaseState& state);

} // namespace bem_contact::app::from_contact
