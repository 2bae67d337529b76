#pragma once

#include "bem_contact/profile/read_profile.hpp"

namespace bem_contact {

/// The curve alone of measured_profile().
inline ProfileCurve read_profile(const std::filesystem::path& file, ProfileKind kind,
                                 const ProfileReading& reading = {}) {
  return measured_profile(file, kind, reading).curve;
}

inline ProfileCurve parse_profile(std::string_view text, std::string_view source_name, ProfileKind kind,
                                  const ProfileReading& reading = {}) {
  return parse_measured_profile(text, source_name, kind, reading).curve;
}

} // namespace bem_contact
