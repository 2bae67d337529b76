#pragma once

#include "bem_contact/profile/profile_curve.hpp"

namespace bem_contact {

/// The S1002 wheel profile from the formulas of EN 13715 (see standard_profiles.hpp).
ProfileCurve s1002_profile();

/// z(y) by the formulas of EN 13715 as they stand, -70 <= y <= 60; at a joint the zone on the field side.
double s1002_height(double y);

} // namespace bem_contact
