#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <vector>

namespace bem_contact {

/// Where points of sections that follow each other correspond, if no features say so: for each section the
/// arc lengths of the same points, from end to end, mm.
///
/// Two neighbours are laid beside each other by dynamic programming over points 1 mm apart (Sakoe and Chiba
/// 1978): corresponding points look the same way and are near to each other if one of the two is moved to
/// where the other is, and their order is the same. What only one of the two has, at either end, corresponds
/// to nothing and is left out. Some of the pairs are kept as marks.
std::vector<std::vector<double>> corresponding_points(const std::vector<BodySection>& sections);

/// The mean distance of two profiles that are laid beside each other so, mm, with 10 mm for each rad by which
/// their directions differ.
double distance_of_profiles(const ProfileCurve& a, const ProfileCurve& b);

/// The same profile with left and right exchanged, walked from the gauge side again.
ProfileCurve mirrored(const ProfileCurve& profile);

} // namespace bem_contact
