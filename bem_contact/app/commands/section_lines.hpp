#pragma once

#include "bem_contact/profile/profile_reading.hpp"
#include "bem_contact/sequence/section_lines.hpp"

#include <optional>
#include <string>

namespace bem_contact::app {

/// The scene that a slices file, or a scene with sections, gives `bem_contact profile`; nothing of any other
/// file.
std::optional<SceneFile> scene_of_sections(const std::string& name, const ProfileReading& reading);

/// SectionLines::points as CSV, with a first line of names.
std::string csv_of(const SectionLines& lines);

} // namespace bem_contact::app
