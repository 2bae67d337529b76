#pragma once

#include "bem_contact/sequence/contact_case.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// Why fem would refuse a wheel on a rail whose influence files are both there: the contact does not fit on
/// their strips. Empty where they hold the contact. The frictionless problem is solved for this, because a
/// conformal contact is wider than any estimate without elasticity.
std::string refusal_by_strips(const ContactCase& asked);

/// Which strips of both bodies a wheel on a rail needs for fem, line by line, as the table [strip] of their
/// body files (profile/body_file.hpp): the rows that the frictionless contact has with half-space numbers,
/// and strip_reserve beyond them. `contact`: on its first grid.
std::vector<std::string> describe_strips(const ContactCase& asked, const ContactOnGrid& contact);

} // namespace bem_contact
