#pragma once

#include "bem_contact/geometry/placement.hpp"

#include <atomic>
#include <optional>
#include <vector>

namespace bem_contact {

/// A rigid wheelset on both its rails.
///
/// Profiles of the left side are given as those of the right side are: in the mirror image, y towards the
/// field (WheelOnRail). `position` is the same for both: gauge, gauge_height, back_to_back, rail_inclination,
/// wheel_radius, rail_origin, wheel_origin. Its side, lateral displacement, roll, yaw and deviations of the
/// rail are not used.
struct WheelsetOnTrack {
  TabulatedProfile right_rail, right_wheel; ///< each in its own frame, mm
  TabulatedProfile left_rail, left_wheel;   ///< likewise, mirrored as above
  WheelsetPosition position;                ///< of both sides, mm and rad
  /// The wheelset rolls until both wheels stand on their rails. False, as the reference results of EN 15302
  /// have it: the wheelset stays upright, and each wheel touches at a height of its own.
  bool rolls = false;
  std::optional<double> left_rail_inclination = {}; ///< rad; empty: as position has it

  double contact_distance() const; ///< nominal: of the two tape circles, mm
};

/// Where one wheel touches. Both points are in the frame of their section: y to the field side, z down, mm.
struct WheelTouch {
  double rail_s = 0, wheel_s = 0; ///< arc length on each profile, mm
  Point2 rail, wheel;             ///< (y, z) of the point on each profile, mm
  double delta = 0;  ///< inclination of the rail's surface there, in the track frame of this side, rad
  double radius = 0; ///< of the wheel there, mm
};

/// The wheelset at one lateral displacement.
struct WheelsetStand {
  double lateral = 0;     ///< mm, to the right
  double roll = 0;        ///< rad, right side down
  WheelTouch right, left; ///< in the frames of their sides

  /// Rolling radius difference, mm: right less left.
  double difference() const { return right.radius - left.radius; }
};

/// The wheelset at a lateral displacement, mm to the right. Throws InputError where a wheel finds no touch
/// point on its rail.
WheelsetStand stand(const WheelsetOnTrack& wheelset, double lateral);

/// The wheelset at lateral displacements from -reach to reach (mm), ascending, in steps of at most
/// conicity::lateral_step, and finer where a contact point moves fast or jumps (settings.hpp). Ends earlier
/// on a side where a wheel finds no touch point. Throws InputError where it finds none at 0, and unless 0 <
/// reach <= 50 mm; Stopped soon after another thread sets `stop`.
std::vector<WheelsetStand> rolling_radius_difference(const WheelsetOnTrack& wheelset, double reach,
                                                     const std::atomic<bool>* stop = nullptr);

} // namespace bem_contact
