#pragma once

#include "bem_contact/geometry/roller.hpp"

namespace bem_contact {

/// The track frame, turned about a point so that its x lies along a rail that rises or falls, or runs to the
/// side, and its y stays level. A place keeps its numbers where nothing is turned.
struct RailFrame {
  Vector3 origin{};                                       ///< what is turned about, track frame, mm
  Vector3 along{1, 0, 0}, across{0, 1, 0}, into{0, 0, 1}; ///< its axes, track frame

  RailFrame() = default;
  /// `direction`: of x, not upright.
  RailFrame(const Vector3& about, const Vector3& direction);

  double rise() const { return along[2] / into[2]; } ///< tan of the pitch; below 0 where the rail rises
  /// Components of a vector of the track frame.
  Vector3 seen(const Vector3& v) const;
  /// And back.
  Vector3 in_track(const Vector3& v) const;
  /// A point of the track frame, mm.
  Vector3 seen_point(const Vector3& p) const;
  /// And back.
  Vector3 point_in_track(const Vector3& p) const;
  /// The wheel as it stands there.
  WheelFrame wheel(const WheelFrame& f) const;
};

} // namespace bem_contact
