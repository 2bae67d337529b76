#include "bem_contact/geometry/level_roll.hpp"

#include <cmath>
#include <optional>

namespace bem_contact {

namespace {

/// 1. Steps to the roll at which both wheels stand on their rails. Each is a secant step; 3 or 4 are usual. A
/// bound.
constexpr int roll_steps = 40;

} // namespace

double level_roll(const std::function<double(double)>& unequal, double roll, double contact_distance,
                  double tolerance) {
  // Roll lowers the right wheel by half the distance of the contacts and lifts the left one, so that
  // `unequal` falls by that distance; the secant knows it better from the second step on. At a kink, where a
  // contact jumps, secants may run to and fro: the bracket ends that.
  double slope = -contact_distance, here = unequal(roll);
  std::optional<double> above, below; // rolls where the right side asks to be lowered more, and less
  for (int i = 0; i < roll_steps && std::abs(here) > tolerance; ++i) {
    const double before = roll, last = here;
    (last > 0 ? above : below) = roll;
    roll -= last / slope;
    if (above && below && !(roll > *above && roll < *below))
      roll = 0.5 * (*above + *below);
    if (roll == before)
      break;
    here = unequal(roll);
    if (const double secant = (here - last) / (roll - before); secant < 0)
      slope = secant;
  }
  return roll;
}

} // namespace bem_contact
