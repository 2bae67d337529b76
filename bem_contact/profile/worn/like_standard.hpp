#pragma once

#include "bem_contact/profile/profile_curve.hpp"
#include "bem_contact/profile/profile_kind.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// A standard profile that a measured one may be worn from.
struct LikeStandard {
  std::string name;
  double least_depth = 0, largest_depth = 0; ///< of the points inside it, mm
  double angle = 0;                          ///< of the measured profile, rad, from +y towards +z
  std::string other = {};                    ///< another standard that is about as like; "": none
};

/// The standard that is most like the curve, if one is near: a quarter of the curve lies on it but for the
/// `scatter` (mm) of its points, hardly any steel lies outside, and a wheel is not turned. Wear takes steel
/// away, so a standard outside of which there is steel is less like than one from which much is worn off.
std::optional<LikeStandard> like_standard(const ProfileCurve& curve, ProfileKind kind, double scatter = 0);

/// By how much a rail is turned in its file, rad, from +y towards +z, if by as much as rails are laid: below
/// 0 towards the track's centre; 0 if it stands upright, or is too worn to tell. The symmetry of its head
/// tells (head_symmetry.hpp); where one side is worn, a standard on which it lies.
double rail_turn(const ProfileCurve& rail, double scatter = 0);
/// Towards the track's centre, rad, else 0. A scene's position.rail_inclination would incline such a rail
/// again.
inline double rail_inclination(const ProfileCurve& rail, double scatter = 0) {
  const double turn = rail_turn(rail, scatter);
  return turn < 0 ? -turn : 0;
}

/// "about 1:40"
std::string inclination_text(double turn);

} // namespace bem_contact
