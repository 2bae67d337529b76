#pragma once

#include <string>
#include <vector>

namespace bem_contact {

/// What would be solved, for people.
struct SceneDescription {
  /// Touch points, estimate, load, grid, friction, influence files and the strips that they need, model.
  std::vector<std::string> lines;
  std::vector<std::string> warnings; ///< input_warnings()
};

} // namespace bem_contact
