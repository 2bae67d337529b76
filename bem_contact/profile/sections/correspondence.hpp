#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"

#include <vector>

namespace bem_contact {

/// Lines through sections that follow each other.
struct CorrespondingPoints {
  /// [section][line] Arc length of the line's point, mm; nan: the section does not have it.
  std::vector<std::vector<double>> marks;
  /// [interval][line] Whether the line goes on from the section before it to the next one.
  std::vector<std::vector<char>> joined;
};

/// The feature lines that the sections give.
CorrespondingPoints given_points(const std::vector<BodySection>& sections);

/// Where points of sections that follow each other correspond, if no features say so. Throws InputError for
/// neighbours that have nothing in common.
///
/// Two neighbours are laid beside each other by dynamic programming over points 1 mm apart (Sakoe and Chiba
/// 1978): corresponding points look the same way and are near to each other if one of the two is moved to
/// where the other is, and their order is the same. What only one of the two has, at either end, corresponds
/// to nothing: there lines end or begin, as those of a nose beside a wing. Lines are some 10 mm apart.
CorrespondingPoints corresponding_points(const std::vector<BodySection>& sections);

/// The mean distance of two profiles that are laid beside each other so, mm, with 10 mm for each rad by which
/// their directions differ.
double distance_of_profiles(const ProfileCurve& a, const ProfileCurve& b);

/// The same profile with left and right exchanged, walked from the gauge side again.
ProfileCurve mirrored(const ProfileCurve& profile);

} // namespace bem_contact
