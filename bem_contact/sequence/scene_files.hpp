#pragma once

#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include <map>
#include <string>

namespace bem_contact {

/// Profiles and influence files of `wheel_rail` scenes, each read once: they must not change meanwhile. One
/// object serves one thread.
class SceneFiles {
public:
  const WheelRailProfiles& profiles(const SceneFile& scene);
  const PairFiles& influence(const SceneFile& scene);

private:
  std::map<std::string, WheelRailProfiles> profiles_;
  std::map<std::string, PairFiles> influence_;
};

} // namespace bem_contact
