#pragma once

#include "meshes/section.hpp"

#include <string_view>

namespace bem_contact::meshes {

/// A REPRESENTATIVE wheel body under a profile: not the drawing of any wheel (none is public), but rim, web
/// and hub of usual size. Radii in mm, y in the wheel's section frame.
struct WheelSection {
  double tape_radius = wheel_reference_radius; ///< where z = 0
  double rim_inner_radius = 390;
  double rim_back = -70, rim_front = 65;    ///< y of the rim's faces
  double web_at_rim = -8, web_at_hub = -38; ///< y of the web's middle: an S between the two
  double thickness_at_rim = 22, thickness_at_hub = 30;
  double fillet = 25; ///< web to rim and to hub
  double hub_radius = 130, bore_radius = 92.5;
  double hub_back = -120, hub_front = 60;
};

/// The outline of the wheel body from the profile's end at the flange back round to its beginning on the
/// field side; `held` is "bore" or "rim" (its inner faces). Throws InputError when the profile's ends do not
/// lie on the rim.
std::vector<Piece> wheel_body(Point2 profile_end, Point2 profile_begin, std::string_view held = "bore",
                              const WheelSection& wheel = {});

} // namespace bem_contact::meshes
