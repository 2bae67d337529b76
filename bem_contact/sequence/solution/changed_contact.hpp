#pragma once

#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/sequence/plan/contact_case.hpp"

namespace bem_contact {

/// What the scene says of the elements of `contact` with one of its numbers changed to both sides, and a half
/// of the difference between the two, in its unit.
struct ChangedContact {
  ContactCase lower_case, upper_case;
  ContactOnGrid lower, upper;
  double step = 0;
};
/// `which`: of derivative_inputs() of the scene.
ChangedContact changed_contact(const ContactCase& asked, const ContactOnGrid& contact, int which);

} // namespace bem_contact
