#include "bem_contact/scene/command_tables.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sstream>

namespace bem_contact {

namespace {

constexpr std::string_view of_compare[] = {"models", "strict", "threads"},
                           of_conicity[] = {"roll", "step", "to"},
                           of_creep_curves[] = {"eta", "jobs", "model", "phi", "strict", "xi"},
                           of_fatigue[] = {"body", "damage", "nodes", "wear_is_negative", "yield_shear"},
                           of_fit[] = {"measured", "model", "parameters", "strict"},
                           of_passage[] = {"columns", "count", "from", "path", "step", "to"},
                           of_replay[] = {"columns", "compare",   "jobs",  "model",
                                          "strict",  "tolerance", "wheel", "wheels"},
                           of_shakedown[] = {"body",     "crossland",      "dang_van", "fatigue_limit",
                                             "in_plane", "initial_stress", "steel",    "yield_shear"},
                           of_table[] = {"jobs", "model", "most_points", "tolerance"},
                           of_wear[] = {"body",      "cap", "depth", "hardness", "influence", "jobs",
                                        "kept_turn", "law", "model", "passages", "smoothing", "speed"};

/// With the names of options, this is what a table of a command may hold.
struct OptionTable {
  std::string_view name;
  std::span<const std::string_view> keys;
};
constexpr OptionTable option_tables[] = {{"compare", of_compare},
                                         {"conicity", of_conicity},
                                         {"creep_curves", of_creep_curves},
                                         {"fatigue", of_fatigue},
                                         {"fit", of_fit},
                                         {"passage", of_passage},
                                         {"replay", of_replay},
                                         {"shakedown", of_shakedown},
                                         {"table", of_table},
                                         {"wear", of_wear}};

void require_known(const std::string& table, const std::string& key, const std::string& where) {
  std::vector<std::string> names = keys_of_table(table);
  for (const std::string_view known : option_keys(table))
    names.emplace_back(known);
  if (std::ranges::find(names, key) != names.end())
    return;
  std::string command = table;
  std::ranges::replace(command, '_', '-');
  const auto like = nearest_names(key, names);
  throw InputError(fmt::format("{}unknown key '{}.{}'", where, table, key),
                   table == "passage" ? std::string("no passage along the track has it")
                                      : fmt::format("the table has the options of bem_contact {}", command),
                   like.empty() ? fmt::format("Known are {}.", fmt::join(names, ", "))
                                : fmt::format("Did you mean {}.{}?", table, fmt::join(like, " or ")));
}

} // namespace

std::span<const std::string_view> option_keys(std::string_view table) {
  const auto found = std::ranges::find(option_tables, table, &OptionTable::name);
  return found == std::ranges::end(option_tables) ? std::span<const std::string_view>() : found->keys;
}

void require_known_options(const toml::table& values, std::string_view table, const std::string& source) {
  for (const auto& [name, node] : values)
    if (table != "table" || !(node.is_table() || node.is_array())) // its axes are keys of the scene
      require_known(std::string(table), std::string(name.str()),
                    fmt::format("{}:{}: ", source, name.source().begin.line));
}

std::vector<std::string> first_names_of_scenes() {
  std::vector<std::string> out;
  for (const KeyDescription& key : keys_of_scenes())
    if (std::string name = key.path.substr(0, key.path.find('.')); std::ranges::count(out, name) == 0)
      out.push_back(std::move(name));
  return out;
}

void require_no_misspelt_section(const SceneText& text, std::string_view section) {
  std::vector<std::string> own{std::string(section)};
  if (section == "sweep")
    own.emplace_back("passage");
  const toml::table root = parse_toml(text.toml);
  const std::vector<std::string> scenes = first_names_of_scenes();
  for (const auto& [name, node] : root) {
    const bool known = std::ranges::count(own, name.str()) + std::ranges::count(scenes, name.str()) > 0;
    const auto like = nearest_names(name.str(), own, 1);
    if (!known && node.is_table() && !like.empty())
      throw InputError(
          fmt::format("{}:{}: unknown table '{}'", text.source, node.source().begin.line, name.str()),
          "a scene has no such table", fmt::format("Did you mean {}?", like[0]));
  }
}

void require_known_options(const SceneText& scene) {
  if (std::ranges::none_of(option_tables, [&](const OptionTable& table) {
        return scene.toml.find(table.name) != std::string::npos;
      }))
    return; // most scenes: saves reading the text once more
  toml::table root;
  try {
    root = parse_toml(scene.toml, scene.source);
  } catch (const toml::parse_error&) {
    return;
  }
  for (const OptionTable& table : option_tables)
    if (const toml::table* values = root[table.name].as_table())
      require_known_options(*values, table.name, scene.source);
}

std::vector<std::string> files_of_table(const SceneText& scene, std::string_view table) {
  std::vector<std::string> out;
  const auto take = [&](const toml::node& node) {
    const auto* text = node.as_string();
    if (!text)
      return;
    const std::filesystem::path file = scene.folder / text->get();
    if (is_regular(file))
      out.push_back(file.string());
  };
  try {
    const toml::table root = parse_toml(scene.toml, scene.source);
    if (const toml::table* values = root[table].as_table())
      for (const auto& [name, node] : *values) {
        if (const toml::array* list = node.as_array())
          for (const toml::node& one : *list)
            take(one);
        else
          take(node);
      }
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
  }
  return out;
}

std::string text_for(const SceneText& scene, std::initializer_list<std::string_view> kept,
                     std::initializer_list<std::string_view> left_out) {
  toml::table root;
  try {
    root = parse_toml(scene.toml, scene.source);
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
