#pragma once

#include "bem_contact/profile/profile_curve.hpp"

#include <span>
#include <vector>

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

/// Says whether a curve is walked as a wheel is, towards -y.
bool is_wheel(const ProfileCurve& curve);

/// A place of a nominal profile on measured points, and how well it is known.
struct UnwornPlace {
  NominalPlace place;
  double share = 0;     ///< of the points that are unworn there: within unworn_distance (settings.hpp)
  double outside = 0;   ///< share of the points that lie outside it by more than that
  double stiffness = 0; ///< how the unworn part holds it: least eigenvalue; 0: it slides
};

/// Places where much of a nominal profile is unworn, the best first; none if the points are of another shape.
/// `scatter` is that of a point, mm; points are in walking order.
///
/// A place is found by least squares with Tukey's weights, whose width shrinks to some scatters: what is worn
/// counts for nothing, however much of it there is. Wear takes steel away, so points outside the nominal
/// profile count up to four times that width. Of a rail, steep parts count more than the top, because wheels
/// reach the top and the gauge corner. The search begins in the file's own frame, and with the tops of both
/// laid on each other, turned and moved as measured profiles are.
std::vector<UnwornPlace> unworn_places(const ProfileCurve& nominal, std::span<const Point2> points,
                                       double scatter);

/// The best of these, to rounding; where there is none, the tops of both are laid on each other: look at the
/// distances.
NominalPlace place_nominal(const ProfileCurve& nominal, std::span<const Point2> points, double scatter);

} // namespace bem_contact
