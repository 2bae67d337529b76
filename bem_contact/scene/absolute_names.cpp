#include "bem_contact/scene/absolute_names.hpp"

#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <algorithm>
#include <sstream>

namespace bem_contact {

std::string absolute_name(const std::string& text, const std::filesystem::path& folder) {
  if (text.empty() || is_standard_profile(text))
    return text;
  const std::size_t part = text.rfind('#'); // of a file with several profiles
  for (const std::size_t end : {text.size(), std::min(part, text.size())})
    if (is_regular(folder / text.substr(0, end)))
      return std::filesystem::absolute(folder / text.substr(0, end)).lexically_normal().string() +
             text.substr(end);
  return text;
}

namespace {

void make_absolute(toml::node& node, const std::filesystem::path& folder) {
  if (toml::table* table = node.as_table())
    for (auto&& [name, inner] : *table)
      make_absolute(inner, folder);
  else if (toml::array* list = node.as_array())
    for (toml::node& inner : *list)
      make_absolute(inner, folder);
  else if (toml::value<std::string>* text = node.as_string())
    *text = absolute_name(text->get(), folder);
}

} // namespace

std::string with_absolute_names(const SceneText& scene) {
  try {
    toml::table root = parse_toml(scene.toml);
    make_absolute(root, scene.folder);
    std::ostringstream out;
    out << root << '\n';
    return out.str();
  } catch (const toml::parse_error&) {
    return scene.toml;
  }
}

} // namespace bem_contact
