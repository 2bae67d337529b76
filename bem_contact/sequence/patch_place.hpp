#pragma once

#include <limits>

namespace bem_contact {

/// Where a patch lies on the two profiles, and how the surfaces move over each other there; all of it at the
/// patch's centre of pressure. nan: there is no such thing (a patch scene has no profiles, a frictionless one
/// no creepage).
struct PatchPlace {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double rail_y = none, rail_z = none; ///< in the frame of the rail's own profile, mm
  /// In the frame of the wheel's own profile, mm; `wheel_delta` is 0 where the wheel's surface is parallel to
  /// its axle, and counts like the rail's, rad.
  double wheel_s = none, wheel_y = none, wheel_z = none, wheel_delta = none;
  /// Rigid slip there, with the creepage found for a prescribed force: along x, along s, and its rotation
  /// about n (1/mm). Shift: mm, mm and rad.
  double xi = none, eta = none, phi = none;
  double body = 0; ///< which of several bodies of the rail's side bears it, from 1; 0: there is one
};

} // namespace bem_contact
