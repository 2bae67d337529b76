#pragma once

#include "bem_contact/geometry/sectioned_wheel.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// A flat of a wheel: the wheel's surface is nearer to the axle there, by the same depth on all of its
/// profile. New it is the chord of the wheel's circle. Run-in its edges are rounded, and it may be longer
/// than the chord of its depth.
struct WheelFlat {
  double length = 0;   ///< along the running surface, mm; 0: that of a chord of this depth
  double depth = 0;    ///< in its middle, mm; 0: that of a chord of this length
  double rounding = 0; ///< length over which each of its two edges is rounded, mm
  double angle = 0;    ///< of its middle: 0 below the axle where `along` is 0, growing forwards, rad

  bool given() const { return length > 0 || depth > 0; } ///< there is one
  bool operator==(const WheelFlat&) const = default;
};

/// How deep the chord of a circle lies below its middle, mm.
double depth_of_chord(double radius, double length);

/// A wheel out of round: the radius grows by sum of amplitude cos(order (angle - phase)).
struct WheelPolygon {
  std::vector<double> orders;     ///< waves on the circumference, whole numbers
  std::vector<double> amplitudes; ///< one for each order, mm
  std::vector<double> phases;     ///< the same, rad, of a crest, counted as WheelFlat::angle; empty: 0

  bool given() const { return !orders.empty(); } ///< there is one
  bool operator==(const WheelPolygon&) const = default;
};

/// A joint of two rails, seen in the rolling direction. The dip is two halves of a parabola that are
/// level at their outer ends, with a kink at the joint.
struct RailJoint {
  double at = 0;            ///< its middle along the track, mm
  double gap = 0;           ///< between the ends of the rails, mm
  double step = 0;          ///< by how much the second rail lies lower, mm; below 0: higher
  double dip = 0;           ///< of both ends below the rails, mm
  double dip_length = 1000; ///< over which the rails dip, half of it on either side, mm
  double rounding = 2;      ///< radius of the edges of both ends where there is a gap or a step, mm

  bool given() const { return gap != 0 || step != 0 || dip != 0; } ///< there is one
  bool operator==(const RailJoint&) const = default;
};

/// How far wheel and rail differ from a round wheel and a straight rail.
struct Unevenness {
  WheelFlat flat;
  WheelPolygon polygon;
  RailJoint joint;
  double along = 0; ///< place of the wheelset along the track, mm: it has rolled there from 0
  /// Where angle 0 of a wheel of sections is when `along` is 0: 0 below the axle, growing forwards, rad.
  double sections_angle = 0;

  bool given() const { return flat.given() || polygon.given() || joint.given(); } ///< any
  bool operator==(const Unevenness&) const = default;
};

/// Throws InputError: `problem` is asked of an uneven wheel or rail, and `why` it has no answer.
[[noreturn]] void refuse_uneven(const std::string& problem, const std::string& why);

/// The same as two functions, seen from the wheelset at its place.
class UnevenSurfaces {
public:
  /// `wheel_radius`: nominal, mm; with it the wheel has rolled. `wheel`: of a wheel of sections; null: it has
  /// one profile.
  UnevenSurfaces(Unevenness what, double wheel_radius,
                 std::shared_ptr<const SectionedSurface> wheel = nullptr);

  /// How far the wheel's surface is off a round wheel with the section below the axle, (y, z) of its section,
  /// mm. `theta`: 0 below the axle, growing forwards, rad. `s`: arc length on that section, mm.
  Point2 wheel(double theta, double s) const {
    return Point2{0, -depth(theta)} + (sections_ ? sections_->offset(theta, s) : Point2{});
  }
  /// How far a flat and waves bring it nearer to the axle there, on all of the profile, mm.
  double depth(double theta) const;
  /// The sections of the wheel; null: it has one profile.
  const SectionedWheel* wheel_sections() const { return sections_ ? &*sections_ : nullptr; }
  /// How far the rail's surface lies lower than a straight rail at x from the wheelset's centre, mm; no_rail
  /// in a gap.
  double rail(double x) const;
  static constexpr double no_rail = 1e4; ///< mm
  /// The greatest difference of heights that both have together, with what a wheel sinks into the gap, mm.
  double range() const { return range_; }

private:
  Unevenness what_;
  double radius_ = 0, turned_ = 0; ///< mm; by how much the wheel has rolled, rad
  double half_angle_ = 0, share_ = 0, blend_ = 0;
  double range_ = 0;
  std::optional<SectionedWheel> sections_ = {};
};

} // namespace bem_contact
