#pragma once

#include "bem_contact/base/scene_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <vector>

namespace bem_contact {

/// Distance of the flange back from the tape circle, mm (EN 13715: the profile's y = -70).
inline constexpr double flange_back_to_tape_circle = 70.0;

/// Where a section stands in the track frame: track = origin + Rot(angle) section, the rotation taking
/// the section's y towards z (about +x). Inclinations grow by `angle`.
struct Pose {
  Point2 origin;
  double angle = 0; ///< rad

  Point2 to_track(Point2 section) const;
  Point2 to_section(Point2 track) const;
};

/// A right-hand wheel on a right-hand rail, yaw 0. Track frame: y from the track's centre line, z down from
/// the highest point of the rail. Both curves stay in their own section frames.
///
/// Rail: inclined by cant towards the track centre; its gauge face (the point nearest to the track centre
/// within gauge_height below the top) is at y = gauge / 2. Without cant its axis is at gauge / 2 plus half
/// the head's width.
/// Wheel: the wheelset's centre is displaced by `lateral` and rolled about that centre; the tape circle is at
/// back_to_back / 2 + 70 mm from it. The wheel's surface is the profile turned about the axle,
/// r = wheel_radius + z of its section.
struct WheelOnRail {
  ProfileCurve rail, wheel;
  Pose rail_pose, wheel_pose;
  double wheel_radius = 460; ///< nominal, at the tape circle, mm

  /// A point of the rail or wheel profile at its own arc length, in the track frame (wheel: in the plane
  /// x = 0). Curvature and s are those of the curve; delta is the track frame's.
  CurvePoint rail_at(double s) const;
  CurvePoint wheel_at(double s) const;
  /// The axle seen from the track, a point of it (above the tape circle), mm.
  Point2 axle() const { return wheel_pose.to_track({0, -wheel_radius}); }
};

/// Places both; the wheel stands with its tape circle wherever the axle height -wheel_radius puts it, so
/// that it may hang above or cut into the rail: see lower_to_touch().
/// Throws InputError where the rail has no gauge face at the given height.
WheelOnRail place(const SceneFile::Position& position, ProfileCurve rail, ProfileCurve wheel);

/// One local minimum of the vertical distance of the two profiles.
struct TouchPoint {
  double rail_s = 0, wheel_s = 0; ///< arc length on either profile, mm
  Point2 position;                ///< on the rail, track frame
  double delta = 0;               ///< inclination of the rail there, rad
  double distance = 0;            ///< vertical distance from rail to wheel, mm (< 0: they overlap)
};

/// All local minima of the vertical distance in the plane x = 0, smallest distance first.
/// Throws InputError when no part of the wheel is above the rail, or when the smallest distance is at the end
/// of a profile.
std::vector<TouchPoint> find_touch_points(const WheelOnRail& pair);

/// Moves the wheel along z until it just touches; returns the touch points then (the first has distance 0).
std::vector<TouchPoint> lower_to_touch(WheelOnRail& pair);

} // namespace bem_contact
