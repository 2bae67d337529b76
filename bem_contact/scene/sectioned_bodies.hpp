#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// The bodies of a side that is given by sections: one, or several of a rail (SceneFile::Section::body).
struct SectionedBodies {
  std::vector<std::string> names; ///< in the order of the scene; "" of the one that there is
  std::vector<std::shared_ptr<const SectionedSurface>> surfaces; ///< none: the side has one profile
  std::optional<ProfileCurve> first;                             ///< the first section of all
};

/// The sections of one of them as they are given.
struct SectionsOfBody {
  std::string name; ///< "" of the one that there is
  SlicedBody body;
};
/// The bodies of a side in the order of the scene; none: the side has one profile. Throws InputError, which
/// names the section.
std::vector<SectionsOfBody> sections_of_bodies(const SceneFile& scene, ProfileKind kind);

/// Reads them. A body of several that has one section is the same all along the track. Throws InputError,
/// which names the section.
SectionedBodies sectioned_bodies(const SceneFile& scene, ProfileKind kind);

} // namespace bem_contact
