#include "bem_contact/scene/command_tables.hpp"

#include "bem_contact/base/toml.hpp"

#include <algorithm>
#include <sstream>

namespace bem_contact {

std::string text_for(const SceneText& scene, std::initializer_list<std::string_view> kept,
                     std::initializer_list<std::string_view> left_out) {
  toml::table root;
  try {
    root = toml::parse(scene.toml, scene.source);
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
    return scene.toml;
  }
  const auto drop = [&](std::string_view table) {
    if (std::ranges::find(kept, table) == kept.end())
      root.erase(table);
  };
  std::ranges::for_each(command_tables, drop);
  drop("wear");
  for (const std::string_view key : left_out)
    if (toml::table* table = root[key.substr(0, key.find('.'))].as_table())
      table->erase(key.substr(key.find('.') + 1));
  std::ostringstream out;
  out << root;
  return out.str();
}

} // namespace bem_contact
