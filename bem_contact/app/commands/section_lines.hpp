#pragma once

#include "bem_contact/profile/profile_reading.hpp"

#include <optional>
#include <string>

namespace bem_contact::app {

/// What `bem_contact profile` says of a rail or wheel that is given by sections.
struct SectionLines {
  std::string words; ///< how many there are, and from where to where each line goes
  /// Points of the surface on lines of the same t through the sections: body (from 1), t (mm), line (1: a
  /// feature line), section (1: the place of a section), u (mm; of a wheel rad), y, z (mm).
  std::string csv;
};

/// Reads them from a slices file or a scene with sections; nothing of any other file. Throws InputError for
/// sections that make no surface.
std::optional<SectionLines> section_lines(const std::string& name, const ProfileReading& reading);

} // namespace bem_contact::app
