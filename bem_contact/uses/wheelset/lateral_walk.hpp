#pragma once

#include "bem_contact/sequence/lateral/lateral_force.hpp"

#include <optional>

namespace bem_contact {

/// mm. Longest step: a flange takes up its force within a few tenths, and holds it for some millimetres.
inline constexpr double largest_lateral_step = 1.0;

/// The displacement nearest to `start` at which the lateral forces on both rails add up to about `wanted`, N;
/// within rough_lateral_width. `force`: this sum at a displacement, nothing where the wheelset does not
/// stand. On the flange the force grows with the displacement until a wheel climbs its rail, so the search
/// goes to that side. On the tread it may fall, too: to the other side as well where the start is `near` the
/// force, or where the force at first falls. `best` is the one on the way that is nearest to the wanted one;
/// nothing if that is not met.
std::optional<LateralRoot> search_lateral(const LateralForce& force, const LateralSample& start,
                                          double wanted, bool near, LateralSample& best);

/// How a search for a lateral force ended that is not met.
struct FailedSearch {
  double wanted = 0, start = 0;
  LateralSample best; ///< the force nearest to it
  bool lifts = false; ///< a wheel lifts beyond
  double roll_moment = 0;
  double of_curve = 0; ///< N, in `wanted`
};

/// Throws InputError.
[[noreturn]] void refuse_lateral(const FailedSearch& failed);

} // namespace bem_contact
