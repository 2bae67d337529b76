#pragma once

#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/sequence/section_lines.hpp"

#include <optional>
#include <string>

namespace bem_contact::app {

/// What `bem_contact profile` says of a slices file, or of a scene with sections; nothing of any other file.
/// Throws InputError for sections that make no surface.
std::optional<SectionLines> lines_of_file(const std::string& name, const ProfileReading& reading);

/// SectionLines::points as CSV, with a first line of names.
std::string csv_of(const SectionLines& lines);

} // namespace bem_contact::app
