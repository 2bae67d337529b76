#pragma once

#include "bem_contact/sequence/plan/contact_case.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// What would be solved, for people.
struct SceneDescription {
  /// Touch points, estimate, load, grid, friction, influence files and the strips that they need, model.
  std::vector<std::string> lines;
  std::vector<std::string> warnings; ///< input_warnings()
};

/// Throws InputError where the grid that is asked for cannot be.
SceneDescription describe_case(const ContactCase& asked);

} // namespace bem_contact
