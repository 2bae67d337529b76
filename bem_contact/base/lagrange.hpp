#pragma once

#include <cstddef>
#include <span>

namespace bem_contact {

/// The polynomial through values at these places is at `at` the sum of the values times these weights.
/// Lagrange's form; as many weights as places, no two of which are equal.
inline void lagrange_weights(std::span<const double> places, double at, std::span<double> weights) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights[i] = 1;
    for (std::size_t j = 0; j < places.size(); ++j)
      if (j != i)
        weights[i] *= (at - places[j]) / (places[i] - places[j]);
  }
}

} // namespace bem_contact
