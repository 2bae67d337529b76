#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <span>

namespace bem_contact {

/// Where a nominal profile lies in the frame of measured points: turned by `angle`, then moved by `shift`.
struct NominalPlace {
  Point2 shift;     ///< (y, z), mm
  double angle = 0; ///< rad, from +y towards +z

  Point2 to_nominal(Point2 measured) const { return turned(measured - shift, -angle); }
  Point2 to_measured(Point2 nominal) const { return turned(nominal, angle) + shift; }
};

/// A measured point as seen from the nominal profile.
struct PointOnNominal {
  double s = 0;       ///< arc length of the nearest point of the nominal profile, mm
  Point2 normal;      ///< of the nominal profile there, into the body, in its own frame
  double depth = 0;   ///< along the nominal normal, into the body, mm: how much is worn off
  bool beyond = true; ///< it lies more than beyond_end (settings.hpp) beyond an end of the nominal profile
};
PointOnNominal seen_from(const ProfileCurve& nominal, Point2 measured, const NominalPlace& place);

/// Places the nominal profile by what is not worn: first by least sum of distances, then by least squares
/// with Tukey's weights, which leave out what is off by more than 4.7 times what is usual. `scatter` is that
/// of a point, mm. Points beyond the ends of the nominal profile do not count. It begins in the file's own
/// frame, and if that is far off, with the tops of both laid on each other. There may be no good place: look
/// at the distances.
NominalPlace place_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter);

} // namespace bem_contact
