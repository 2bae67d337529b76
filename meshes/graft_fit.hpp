#pragma once

#include "bem_contact/profile/worn/nominal_place.hpp"
#include "meshes/section.hpp"

#include <string>

namespace bem_contact::meshes {

/// Where a standard body lies in the frame of a measured profile.
struct GraftPlace {
  NominalPlace place;
  double share = 0;       ///< of the profile that lies on the body there, unworn
  std::string doubt = {}; ///< why the profile is probably not worn from that standard; "": it may be
};

/// Lays the standard `base` on the unworn part of a measured profile, as scenes with a nominal profile do
/// (profile/worn/nominal_place.hpp). Throws InputError if less than a third of the profile is unworn there,
/// if that part would slide (an arc, a straight line), or if another place is nearly as good.
GraftPlace find_graft(const ProfileCurve& measured, const std::string& base);

} // namespace bem_contact::meshes
