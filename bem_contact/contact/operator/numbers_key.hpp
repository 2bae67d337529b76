#pragma once

#include "bem_contact/contact/problem.hpp"

#include <cstdint>

namespace bem_contact::contact {

/// Names a set of influence numbers on a grid. Two sets have the same key only if all their values are
/// identical, bit by bit (up to a collision of 64-bit digests). Offsets beyond those of the grid count too.
struct NumbersKey {
  int mx = 0, ms = 0, offsets = 0, rows = 0;
  bool translational = false;
  double dx = 0, ds = 0;
  std::uint64_t digest = 0; ///< of the bits of all values

  bool operator==(const NumbersKey&) const = default;
};

NumbersKey key_of(const ContactProblem& problem);

} // namespace bem_contact::contact
