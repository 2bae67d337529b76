#pragma once

#include "bem_contact/app/from_contact/contact_cases.hpp"

#include <string>

namespace bem_contact::app::from_contact {

/// Joins a case that goes on from the tractions of the one before (P = 0) with it, as one more step. False
/// where a scene has no such steps: another motion, material, distance or size of elements.
bool join(ContactCase& before, const ContactCase& next);
/// What keeps a wheel's case from being one more step of the one before: a key that differs, or where the
/// wheelset is.
std::string other_than(const ContactCase& before, const ContactCase& next);

/// Whether the steps of the case need motion.step_table; steps that are all alike are in the keys.
bool needs_step_table(const ContactCase& one);
/// The table: loads, creepages, forces, and where the contact lies.
std::string step_table(const ContactCase& one);

} // namespace bem_contact::app::from_contact
