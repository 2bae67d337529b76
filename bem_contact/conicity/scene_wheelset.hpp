#pragma once

#include "bem_contact/conicity/rolling_radius.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <span>
#include <string>

namespace bem_contact {

/// The left side of a wheelset, where it is not the mirror image of the right one.
struct LeftProfiles {
  std::string rail, wheel; ///< standard names or files, as in a scene; "": as on the right
};

/// The wheelset of a wheel_rail scene on its track: the scene's profiles on the right and, unless `left` says
/// otherwise, on the left. Files of the left side are read as the right side's are. Throws InputError for a
/// patch and for profiles that cannot be read.
WheelsetOnTrack wheelset_of(const SceneFile& scene, const LeftProfiles& left = {});

/// A scene of the profiles and the track that `changes` give, where there is no file. Its load does not
/// count. Paths start at the working directory. Throws InputError as parse_scene_file() does.
SceneFile scene_without_file(std::span<const SceneChange> changes);

} // namespace bem_contact
