#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <vector>

namespace bem_contact::fem {

/// Radius at which a wheel's angle is measured as a length: x = R_ref theta, r = R_ref + z, mm.
inline constexpr double wheel_reference_radius = 460.0;

double reference_radius_of(const BodyFile& body); ///< R_ref, mm; 0 for prismatic bodies
double half_period_of(const BodyFile& body);      ///< L, mm; pi R_ref for bodies of revolution

/// What the influence function of either method says of the body: names, material, invariance, stations. It
/// has no numbers yet, and the caller says how the body is held and by which method the numbers are made.
InfluenceFunction describe(const BodyFile& body, const ProfileCurve& curve, std::vector<Station> stations);

} // namespace bem_contact::fem
