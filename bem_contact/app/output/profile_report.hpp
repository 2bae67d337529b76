#pragma once

#include "bem_contact/profile/profile_findings.hpp"

#include <string>

namespace bem_contact::app {

/// A profile for people: points, extent, noise, what smoothing removed, what it is like, radii along s.
std::string to_text(const MeasuredProfile& profile, const ProfileFindings& found, ProfileKind kind);

} // namespace bem_contact::app
