#pragma once

#include "bem_contact/scene/scene_file.hpp"

#include <map>
#include <string>
#include <vector>

namespace bem_contact::explore {

/// Files that are no files of this machine: dropped on the page, or kept in a result. By the name that the
/// scene has for them.
using HeldFiles = std::map<std::string, std::string>;

/// What the page shows first.
struct Start {
  SceneText scene;                       ///< may be wrong: the page says so
  std::vector<SceneChange> changes = {}; ///< of the scene
  HeldFiles files = {};
  std::string file = {}; ///< that it comes from; "": none
};

} // namespace bem_contact::explore
