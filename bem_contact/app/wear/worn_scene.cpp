#include "bem_contact/app/wear/worn_scene.hpp"

#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/absolute_names.hpp"

#include <fmt/format.h>
#include <sstream>
#include <utility>

namespace bem_contact::app {

namespace {

/// How a profile file is read: what wear writes needs none of it.
constexpr const char* reading_keys[] = {"profile", "sections",  "smoothing", "nominal",
                                        "unit",    "profile_z", "mirror",    "flange_back"};

void take_profiles(toml::table& side) {
  for (const char* key : reading_keys)
    side.erase(key);
  side.insert("profile_z", "down");
  side.insert("unit", "mm");
}

toml::array list_of(const std::vector<double>& values) {
  toml::array out;
  for (const double value : values)
    out.push_back(value);
  return out;
}

toml::table table_of(const SceneFile::Section& section) {
  toml::table out{{"at", section.at}, {"profile", section.profile}};
  if (!section.features.empty())
    out.insert("features", list_of(section.features));
  if (!section.without.empty())
    out.insert("without", list_of(section.without));
  if (section.kink)
    out.insert("kink", true);
  if (!section.body.empty())
    out.insert("body", section.body);
  return out;
}

} // namespace

std::string worn_scene(const SceneText& scene, const WearState& state) {
  toml::table root = parse_toml(with_absolute_names(scene));
  toml::array sections;
  for (std::size_t i = 0; i < state.pair.sections.size(); ++i)
    sections.push_back(
        table_of(wear::section_in_scene(state.pair.sections[i], section_file(i, state.step()))));
  toml::table& rail = *root["rail"].as_table();
  take_profiles(rail);
  rail.insert("sections", std::move(sections));
  if (toml::table* wheel = root["wheel"].as_table(); wheel && state.pair.wheel.largest() > 0) {
    take_profiles(*wheel);
    wheel->insert("profile", step_file("wheel", state.step(), "txt"));
  }
  std::ostringstream out;
  out << fmt::format("# Worn by bem_contact wear, step {}: {:.6g} revolutions of the wheel.\n", state.step(),
                     state.pair.revolutions)
      << root << '\n';
  return out.str();
}

} // namespace bem_contact::app
