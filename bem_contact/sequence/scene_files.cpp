#include "bem_contact/sequence/scene_files.hpp"

#include <fmt/format.h>

namespace bem_contact {

const WheelRailProfiles& SceneFiles::profiles(const SceneFile& scene) {
  const std::string key =
      fmt::format("{}\n{}\n{}", scene.folder.string(), scene.rail.profile, scene.wheel.profile);
  const auto found = profiles_.find(key);
  return found != profiles_.end() ? found->second
                                  : profiles_.emplace(key, read_profiles(scene)).first->second;
}

const PairFiles& SceneFiles::influence(const SceneFile& scene) {
  std::string key = scene.folder.string();
  for (const SceneFile::Side* side : {&scene.rail, &scene.wheel}) // the reader checks the material
    key += fmt::format("\n{}\n{} {}", side->influence, side->material.shear_modulus, side->material.poisson);
  const auto found = influence_.find(key);
  return found != influence_.end() ? found->second
                                   : influence_.emplace(key, read_pair_files(scene)).first->second;
}

} // namespace bem_contact
