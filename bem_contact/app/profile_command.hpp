#pragma once

#include "bem_contact/app/command.hpp"
#include "bem_contact/profile/read_profile.hpp"

#include <string>

namespace bem_contact::app {

/// `bem_contact profile FILE`.
Command add_profile(CLI::App& program);

/// Rail or wheel: a standard by its name, a file by its ending (.prr, .ban, .rai; .prw, .whl, .whe) or by
/// `kind`
/// ("rail", "wheel"). Throws InputError where neither says it.
ProfileKind kind_of_profile(const std::string& name_or_file, const std::string& kind);

/// The profile in words: points, extent, noise, what smoothing removed, radii along s.
std::string describe_profile(const MeasuredProfile& profile, ProfileKind kind);

/// One line for each of equal steps of arc length, at most `step` mm long: s, y, z, inclination, curvature.
std::string profile_csv(const ProfileCurve& curve, double step);

} // namespace bem_contact::app
