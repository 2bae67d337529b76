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
  /// Of a rail that is turned towards the track's centre by as much as rails are laid, and lies on the
  /// standard so well that the turn can be told: that inclination, rad; else 0. A scene's position.cant
  /// would incline such a rail again.
  double inclination = 0;
};

/// The standard that is most like the curve, if one is near. Wear takes steel away, so a standard outside of
/// which there is steel is less like than one from which much is worn off.
std::optional<LikeStandard> like_standard(const ProfileCurve& curve, ProfileKind kind);

/// "about 1:40"
std::string inclination_text(double inclination);

} // namespace bem_contact
