#pragma once

#include "bem_contact/geometry/pose.hpp"
#include "bem_contact/geometry/roller.hpp"
#include "bem_contact/geometry/sectioned_rail.hpp"
#include "bem_contact/geometry/tabulated_profile.hpp"
#include "bem_contact/geometry/unevenness.hpp"
#include "bem_contact/profile/profile_reading.hpp"

#include <memory>
#include <optional>

namespace bem_contact {

/// Says on which side of the track the wheel is, seen in the rolling direction.
enum class WheelSide { right, left };

/// Where a wheel of a flexible wheelset is, seen from where the rigid wheelset has it (base/conventions.hpp
/// says the order).
struct WheelDeviation {
  double lateral = 0, vertical = 0; ///< mm, to the right and down
  double roll = 0, yaw = 0;         ///< rad, right side down and front to the right, about its own centre

  bool operator==(const WheelDeviation&) const = default;
};

/// Where a wheelset stands on its track, and where the rail under one of its wheels lies.
struct WheelsetPosition {
  WheelSide side = WheelSide::right; ///< which of its two wheels
  double lateral = 0;                ///< lateral displacement of the wheelset, mm, positive to the right
  double gauge = 1435;               ///< mm
  double gauge_height = 14;          ///< where the gauge is measured: below the top of the running head, mm
  double back_to_back = 1360;        ///< distance between the flange backs, mm
  double tape_circle = flange_back_to_tape_circle; ///< distance of the tape circle from the flange back, mm
  double rail_inclination = 0;                     ///< rail inclination towards the track centre, rad
  double roll = 0;                                 ///< wheelset roll, rad, right side down
  double yaw = 0;                                  ///< wheelset yaw, rad, front to the right
  double wheel_radius = 460;                       ///< nominal, at the tape circle, mm
  /// Deviations of the rail from where gauge and inclination put it: to the right, down, and turned right
  /// side down.
  double rail_lateral = 0, rail_vertical = 0, rail_roll = 0; ///< mm, mm, rad
  /// This is where the origin of a section is put, (y, z) in mm, for bodies without a gauge face or a flange.
  /// Rail: in the track frame, instead of gauge and gauge_height. Wheel: y from the wheelset's centre,
  /// instead of back_to_back; z below the height at which a wheel of wheel_radius has its tape circle.
  std::optional<Point2> rail_origin = {};
  std::optional<Point2> wheel_origin = {}; ///< as rail_origin
  /// Of a roller rig, mm: the axis of the rail lies so far below z = 0 (and moves down with rail_vertical);
  /// 0: a straight rail.
  double roller_radius = 0;
  WheelDeviation deviation = {}; ///< of this wheel, in a flexible wheelset
  Unevenness uneven = {};        ///< of a wheel that is not round, and of a joint of the rail

  bool operator==(const WheelsetPosition&) const = default;
};

/// A wheel on a rail. Track frame: x from the wheelset's centre, y from the track's centre line towards the
/// side of this wheel, z down from the highest point of the rail's running head (running_head.hpp; as it
/// stands without deviations). Both curves stay in their own section frames.
///
/// A wheel on the left is its mirror image: y to the left, and yaw, roll and lateral displacement change
/// sign. Longitudinal quantities, pressures and Fz are what they are; those along y or s, and moments about
/// z, are counted to the left.
///
/// Rail: inclined by rail_inclination towards the track centre; its gauge face (the point nearest to the
/// track centre within gauge_height below the top) is at y = gauge / 2. (So an upright rail's axis, y = 0 of
/// its section, is half the head's width farther out.) Then the rail is moved by its deviations and turned
/// about the origin of its section. Wheel: the wheelset's centre is displaced by `lateral`; the wheelset is
/// rolled about it (right side down), then yawed about the vertical through it (right-hand side backwards).
/// The tape circle is at back_to_back / 2 + tape_circle from it. The wheel's surface is the profile turned
/// about the axle, r = wheel_radius + z of its section. In a flexible wheelset this wheel is then moved by
/// its WheelDeviation. On a roller rig the rail is a Roller, and all places are unrolled ones.
/// WheelsetPosition::rail_origin and wheel_origin put the origins of the sections elsewhere.
///
/// An uneven rail is looked at straightened: what lies lower by UnevenSurfaces::rail(x) is lifted by as much,
/// and the wheel above it with it. So the rail is the same all along x again, and distances along z are what
/// they are. To first order in the slope of the rail all else is too.
///
/// A rail of sections is looked at in the frame of its SectionedRail, and so are the wheel (wheel_frame())
/// and all places on either: the rail is the section there, a prism, with a relief. Poses are those of the
/// track frame, and the wheel is lowered along the track's z.
struct WheelOnRail {
  TabulatedProfile rail, wheel;      ///< in their own section frames
  Pose rail_pose, wheel_pose;        ///< wheel_pose is that before the yaw; rail_pose is final
  double wheel_radius = 460;         ///< nominal, at the tape circle, mm
  double yaw = 0;                    ///< rad, towards +y in front
  double centre_y = 0;               ///< the vertical about which it is yawed, mm
  std::optional<Roller> roller = {}; ///< nothing: the rail is straight
  WheelDeviation deviation = {};     ///< in the frame of its side; all but its yaw are in wheel_pose already
  std::optional<UnevenSurfaces> uneven = {};  ///< nothing: the wheel is round and the rail the same along x
  std::optional<SectionedRail> sections = {}; ///< nothing: the rail has one section
  double surface_speed = 1; ///< along the rail's surface, over V: above 1 where it rises or falls
  double sinking = 0;       ///< of the wheel as it rolls along the rail of sections, over V

  /// A point of the rail's profile at its own arc length, in the track frame; delta too, curvature as it is.
  CurvePoint rail_at(double s) const;
  /// A point of the rail at x, where it is in space: of an uneven rail or one of sections no longer on the
  /// prism.
  Vector3 in_space(double x, const ContactRow& row) const {
    return sections ? sections->point(x, row) : Vector3{x, row.position.y, row.position.z + rail_lower(x)};
  }
  /// By how much it is lifted at x, mm; 0 on an even rail and in a gap, where there is none.
  double rail_lower(double x) const {
    const double lower = uneven ? uneven->rail(x) : 0;
    return lower < UnevenSurfaces::no_rail ? lower : 0;
  }
  WheelFrame wheel_frame() const;    ///< the wheel as it is yawed and rolled, as the rail is looked at
  WheelFrame wheel_in_track() const; ///< the same in the track frame
  /// Where the vertical about which the wheelset is yawed meets its axle, as the rail is looked at, mm.
  Vector3 wheelset_centre() const;
  /// A vector of the track frame, as the rail is looked at.
  Vector3 seen(const Vector3& v) const { return sections ? sections->frame().seen(v) : v; }
  /// cos of the rail's pitch: how much of the track's z lies along z of the frame.
  double upright() const { return sections ? sections->frame().into[2] : 1; }
};

/// Places both. The wheelset's centre is at z = -wheel_radius, so that the wheel may hang above the rail or
/// cut into it: see lower_to_touch(). `surface`: of a rail of sections, of which `rail` is the one that gauge
/// and top are taken from; nothing: it has this section alone. It is looked at from where the wheel touches
/// it first. `wheel_surface`: of a wheel of sections, the same. Throws InputError where a rail that is placed
/// by its gauge face has none at the given height, where a roller's axis is not below all of the rail, for
/// unevenness on a roller, and where the wheel stands off the sections.
WheelOnRail place(const WheelsetPosition& position, TabulatedProfile rail, TabulatedProfile wheel,
                  const std::shared_ptr<const RailSurfaces>& surface = {},
                  const std::shared_ptr<const SectionedSurface>& wheel_surface = {});

} // namespace bem_contact
