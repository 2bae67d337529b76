#pragma once

#include "bem_contact/influence/influence_function.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/profile_curve.hpp"

#include <vector>

namespace bem_contact::fem {

/// The stations of the strip, ascending in s. Throws InputError where the strip is empty, leaves the curve or
/// is not a whole number of stations.
std::vector<Station> make_stations(const BodyFile::Strip& strip, const ProfileCurve& curve);

} // namespace bem_contact::fem
