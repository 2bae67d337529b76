#pragma once

#include "bem_contact/profile/sections/sectioned_surface.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bem_contact {

/// The influence file of one of a rail's sections.
struct SectionInfluence {
  int body = 0;               ///< in the order of the scene
  bool all_along = false;     ///< it is the only section of its body
  double at = 0;              ///< place of the section (SectionedSurface::places()), mm
  std::filesystem::path file; ///< of its influence functions
  std::string profile;        ///< name and digest (ProfileCurve) of the section
  std::uint64_t digest = 0;

  bool operator==(const SectionInfluence&) const = default;
};

/// The bodies of a side that is given by sections: one, or several of a rail (SceneFile::Section::body).
struct SectionedBodies {
  std::vector<std::string> names; ///< in the order of the scene; "" of the one that there is
  std::vector<std::shared_ptr<const SectionedSurface>> surfaces; ///< none: the side has one profile
  std::optional<ProfileCurve> first;                             ///< the first section of all
  std::vector<SectionInfluence> influence;                       ///< by body, and by rising place
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
