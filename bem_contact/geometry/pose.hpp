#pragma once

#include "bem_contact/base/conventions.hpp"

namespace bem_contact {

/// Where a section stands in the track frame: track = origin + Rot(angle) section, the rotation taking
/// the section's y towards z (about +x). Inclinations grow by `angle`.
struct Pose {
  Point2 origin;    ///< of the section, in the track frame, mm
  double angle = 0; ///< rad

  Point2 to_track(Point2 section) const { return origin + turned(section, angle); } ///< a point of it, mm
  Point2 to_section(Point2 track) const { return turned(track - origin, -angle); }  ///< and back
};

} // namespace bem_contact
