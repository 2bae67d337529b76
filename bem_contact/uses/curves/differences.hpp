#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace bem_contact {

/// What is computed at some points less what was measured there, in their unit.
struct Differences {
  std::vector<double> each;
  double mean = 0, root_mean_square = 0;
  double largest = 0;             ///< of the magnitudes
  std::size_t within_scatter = 0; ///< points that differ by no more than their scatter; 0 without one

  /// Equally many of each; `scatter`: standard deviation of what was measured, may be empty.
  Differences(std::span<const double> computed, std::span<const double> measured,
              std::span<const double> scatter);
};

} // namespace bem_contact
