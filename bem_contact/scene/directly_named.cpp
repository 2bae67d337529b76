#include "bem_contact/scene/directly_named.hpp"

#include "bem_contact/profile/read_profile.hpp"

#include <fmt/format.h>
#include <utility>

namespace bem_contact {

std::vector<NamedFile> directly_named(const SceneFile& scene) {
  std::vector<NamedFile> files;
  const auto add = [&](const char* key, const std::string& name) {
    if (!name.empty())
      files.push_back(
          {key, name, names_profile(key) ? profile_file_name(name, scene.folder).file : scene.folder / name});
  };
  for (const auto& [name, side] : {std::pair{"rail", &scene.rail}, {"wheel", &scene.wheel}}) {
    if (side->sections.empty())
      add(fmt::format("{}.profile", name).c_str(), side->profile);
    for (std::size_t i = 0; i < side->sections.size(); ++i) {
      add(fmt::format("{}.sections[{}].profile", name, i).c_str(), side->sections[i].profile);
      add(fmt::format("{}.sections[{}].influence", name, i).c_str(), side->sections[i].influence);
    }
  }
  add("left_rail.profile", scene.wheelset.left_rail.profile);
  add("left_wheel.profile", scene.wheelset.left_wheel.profile);
  add("left_rail.influence", scene.wheelset.left_rail.influence);
  add("left_wheel.influence", scene.wheelset.left_wheel.influence);
  add("rail.influence", scene.rail.influence);
  add("wheel.influence", scene.wheel.influence);
  add("gap.table", scene.gap.table);
  add("strip.inclination", scene.strip.inclination);
  add("motion.slip_table", scene.motion.slip_table);
  add("motion.friction_table", scene.motion.friction_table);
  add("motion.step_table", scene.motion.step_table);
  add("motion.start_table", scene.motion.start_table);
  add("layer.table", scene.layer.table);
  return files;
}

} // namespace bem_contact
