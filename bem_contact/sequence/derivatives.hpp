#pragma once

#include "bem_contact/contact/tangent.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bem_contact {

/// Derivatives of one result with respect to one number of its scene, on the same elements.
struct InputDerivatives {
  std::string name, key, unit;              ///< of the number: "lateral", "position.lateral", "mm"
  std::vector<double> totals;               ///< of derived_totals(); nan: the result does not have it
  std::vector<std::vector<double>> patches; ///< of derived_patch_numbers(), for each patch
  double below = 0, above = 0;              ///< Tangent has these, in the unit of the number
  StateChange at_below = StateChange::none, at_above = StateChange::none; ///< likewise
};

/// Derivatives of one result with respect to every point of a profile, moved out of the body along its
/// normal.
struct ProfileDerivatives {
  std::string name;               ///< "rail_profile"
  std::vector<CurvePoint> points; ///< where the profile stands in its own frame
  std::vector<InputDerivatives>
      by_point; ///< per mm; too far from the contact to change it: zeros, no patches
};

/// Names of quantities() and patch_quantities() that have derivatives. What counts elements has none, and so
/// has the area: it changes by whole elements.
std::span<const std::string_view> derived_totals();
std::span<const std::string_view> derived_patch_numbers();

} // namespace bem_contact
