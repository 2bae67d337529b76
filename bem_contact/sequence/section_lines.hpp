#pragma once

#include "bem_contact/record/record.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <optional>
#include <string>

namespace bem_contact {

/// Which points of the sections of a rail or wheel correspond.
struct SectionLines {
  std::string words; ///< how many lines there are, and from where to where each goes
  /// Points of the surface on lines of the same t through the sections: body (from 1), t (mm), line (1: a
  /// feature line), section (1: the place of a section), u (mm; of a wheel rad), y, z (mm).
  record::Table points;
};

/// Nothing of a scene whose bodies have one profile each. `name`: of the scene, in the words. Throws
/// InputError for sections that make no surface.
std::optional<SectionLines> section_lines(const SceneFile& scene, const std::string& name);

} // namespace bem_contact
