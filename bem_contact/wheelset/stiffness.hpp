#pragma once

#include "bem_contact/wheelset/wheel_pair.hpp"

namespace bem_contact {

/// How forces and moments on both rails change, per mm and rad of the wheelset's motion: a model, good to
/// some ten percent (find_equilibrium()).
struct WheelsetStiffness {
  Wrench by_height, by_roll; ///< down; right side down
  Wrench by_rolling_radius;  ///< at a constant forward speed
};

/// Each patch keeps the direction of its force, and its size grows with its approach as Hertz's law has it.
/// The longitudinal force grows with creepage as Kalker's linear theory has it for a circle of the patch's
/// size, and less near full slip (Vermeulen and Johnson 1964).
WheelsetStiffness stiffness_of(const WheelsetState& state, const SceneFile& scene);

} // namespace bem_contact
