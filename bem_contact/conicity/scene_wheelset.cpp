#include "bem_contact/conicity/scene_wheelset.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/wheel_rail_geometry.hpp"

namespace bem_contact {

WheelsetOnTrack wheelset_of(const SceneFile& scene, const LeftProfiles& left) {
  if (scene.kind != SceneKind::wheel_rail)
    throw InputError("This scene has no wheelset", "its kind is \"patch\"",
                     "Give a scene with kind = \"wheel_rail\".");
  const WheelRailProfiles right = read_profiles(scene);
  const auto other = [&](const std::string& name, ProfileKind kind, const SceneFile::Side& side,
                         const TabulatedProfile& same) {
    return name.empty() ? same : TabulatedProfile(named_profile(name, kind, scene.folder, side.reading));
  };
  return {.right_rail = right.rail,
          .right_wheel = right.wheel,
          .left_rail = other(left.rail, ProfileKind::rail, scene.rail, right.rail),
          .left_wheel = other(left.wheel, ProfileKind::wheel, scene.wheel, right.wheel),
          .position = scene.position};
}

SceneFile scene_without_file(std::span<const SceneChange> changes) {
  return parse_scene_file("load.force = 1.0\n", "options", changes);
}

} // namespace bem_contact
