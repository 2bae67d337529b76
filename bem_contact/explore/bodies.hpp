#pragma once

#include "bem_contact/scene/scene_file.hpp"
#include "bem_contact/sequence/scene_result.hpp"

#include <string>
#include <vector>

namespace bem_contact::explore {

/// A body whose influence functions a scene lacks.
struct BodyToCompute {
  std::string side; ///< "rail", "wheel"
  std::string toml; ///< its body file; paths as the scene has them
};

/// The body files of a rail and a wheel whose strips hold the contact of `solved`, which is the scene's by
/// the half-space. Throws InputError for a scene whose bodies cannot be made from its profiles alone.
std::vector<BodyToCompute> bodies_of(const SceneFile& scene, const SceneResult& solved);

} // namespace bem_contact::explore
