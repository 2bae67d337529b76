#include "bem_contact/app/commands/section_lines.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

namespace bem_contact::app {

namespace {

/// Whether a file is a scene whose rail or wheel is given by sections.
bool is_scene_of_sections(const std::string& name) {
  if (std::filesystem::path(name).extension() != ".toml" || !is_regular(name))
    return false;
  try {
    const toml::table file = parse_toml(read_text_file(name, "scene file"), name);
    return std::ranges::any_of(std::array{"rail", "wheel"}, [&](const char* side) {
      return file[side]["sections"] || names_slices(file[side]["profile"].value_or(std::string()));
    });
  } catch (const toml::parse_error&) { // whoever reads it as something else says what is wrong
    return false;
  }
}

} // namespace

std::optional<SceneFile> scene_of_sections(const std::string& name, const ProfileReading& reading) {
  if (const auto kind = kind_of_slices(name)) {
    SceneFile scene;
    SceneFile::Side& side = *kind == ProfileKind::wheel ? scene.wheel : scene.rail;
    side.profile = name;
    side.reading = reading;
    side.reading.keep_origin = true;
    return scene;
  }
  return is_scene_of_sections(name) ? std::optional(read_scene_file(name)) : std::nullopt;
}

std::string csv_of(const SectionLines& lines) {
  std::string out = "body,t,line,section,u,y,z\n";
  const std::vector<record::Column>& columns = lines.points.columns;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const auto at = [&](std::size_t column) { return columns[column].values[i]; };
    out += fmt::format("{:g},{:.6g},{:g},{:g},{:.6g},{:.6f},{:.6f}\n", at(0), at(1), at(2), at(3), at(4),
                       at(5), at(6));
  }
  return out;
}

} // namespace bem_contact::app
