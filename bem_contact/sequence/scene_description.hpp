#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace bem_contact {

/// What would be solved, for people.
struct SceneDescription {
  /// Touch points, estimate, load, grid, friction, influence files and the strips that they need, model.
  std::vector<std::string> lines;
  std::vector<std::string> warnings; ///< input_warnings()

  /// All lines, and the warnings that are not there yet.
  void add(const SceneDescription& other) {
    lines.insert(lines.end(), other.lines.begin(), other.lines.end());
    for (const std::string& warning : other.warnings)
      if (std::ranges::find(warnings, warning) == warnings.end())
        warnings.push_back(warning);
  }
};

} // namespace bem_contact
