#pragma once

#include "bem_contact/conicity/equivalent_conicity.hpp"
#include "bem_contact/conicity/rolling_radius.hpp"

#include <optional>
#include <vector>

namespace bem_contact {

/// Amplitudes for which the conicity is wanted: step, 2 step, .. up to `largest`, mm.
struct Amplitudes {
  double largest = 10, step = 1; ///< mm
};

/// All that follows from the shapes of a wheelset and its track.
struct WheelsetConicity {
  /// One amplitude; `motion` is empty where there is none (equivalent_conicity.hpp).
  struct Value {
    double amplitude = 0;                     ///< mm
    std::optional<EquivalentConicity> motion; ///< with this amplitude
  };
  KlingelLengths lengths;            ///< of the wheelset
  std::vector<WheelsetStand> stands; ///< in rising order of lateral displacement
  std::vector<Value> values;         ///< in rising order of the amplitude
};

/// Throws InputError where a wheel finds no touch point at displacement 0, for amplitudes beyond 45 mm, and
/// for more than 10000 of them.
WheelsetConicity wheelset_conicity(const WheelsetOnTrack& wheelset, const Amplitudes& amplitudes = {});

} // namespace bem_contact
