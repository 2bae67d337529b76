#pragma once

#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/worn/gauged_numbers.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// What can be told of a profile once it is read.
struct ProfileFindings {
  std::optional<LikeStandard> like; ///< of a measured one
  double turn = 0;                  ///< of a measured rail in its file: rail_turn()
  std::optional<FlangeNumbers> flange;
  /// Of a rail worn from a standard: from the one that is given as nominal, else from the one it is like.
  std::optional<HeadWear> wear;

  /// Towards the track's centre, rad: position.rail_inclination would incline such a rail again.
  double inclination() const { return turn < 0 ? -turn : 0; }
};

ProfileFindings findings_of(const MeasuredProfile& profile, ProfileKind kind, const ProfileReading& reading);

/// What is wrong with a rail that is turned away from the track's centre in its file, and what to do; "":
/// nothing.
std::string leans_outwards(double turn);

} // namespace bem_contact
