#pragma once

#include "bem_contact/scene/warning.hpp"

#include <string>
#include <vector>

namespace bem_contact {

/// What would be solved, for people.
struct SceneDescription {
  /// Touch points, estimate, load, grid, friction, influence files and the strips that they need, model.
  std::vector<std::string> lines;
  Warnings warnings; ///< input_warnings()

  /// All lines, and the warnings that are not there yet.
  void add(const SceneDescription& other) {
    lines.insert(lines.end(), other.lines.begin(), other.lines.end());
    warnings.add(other.warnings);
  }
};

} // namespace bem_contact
