#pragma once

#include "bem_contact/sequence/contact_case.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// What would be solved, line by line: touch points, estimate, load, grid, friction, influence files, model,
/// warnings. Throws InputError where the grid that is asked for cannot be.
std::vector<std::string> describe_case(const ContactCase& asked);

} // namespace bem_contact
