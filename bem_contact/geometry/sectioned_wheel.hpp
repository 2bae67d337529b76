#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <memory>
#include <vector>

namespace bem_contact {

/// A wheel whose section changes round it, as it stands at one place along the track.
///
/// It is looked at as a wheel that has the section below its axle all round, and how far the true surface is
/// off that: each point of the section moves within the plane through the axle as the angle grows, and its t
/// (SectionedSurface) stays. Every point that comes out lies on the true surface.
class SectionedWheel {
public:
  /// `surface`: closed round the wheel, u in rad (wheel_surface()). `turned`: the angle that is below the
  /// axle, rad.
  SectionedWheel(std::shared_ptr<const SectionedSurface> surface, double turned);

  /// Below the axle.
  const ProfileCurve& section() const { return section_; }
  /// From the point of the section at arc length s to the same one at the angle theta (0 below the axle,
  /// growing forwards, rad), (y, z) of the section, mm.
  Point2 offset(double theta, double s) const;
  /// The greatest difference of heights between its sections along their normals, mm.
  double range() const { return range_; }

private:
  double angle(double theta) const;
  double greatest_difference() const;

  std::shared_ptr<const SectionedSurface> surface_;
  double turned_ = 0;
  std::vector<double> s_, t_; ///< of the nodes of the section
  ProfileCurve section_;
  double range_ = 0;
};

} // namespace bem_contact
