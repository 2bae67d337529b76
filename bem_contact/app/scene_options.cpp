#include "bem_contact/app/scene_options.hpp"

#include "bem_contact/app/output/repeat.hpp"
#include "bem_contact/base/argument_error.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/scene/absolute_names.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>

namespace bem_contact::app {

namespace {

/// Tables with the name of a command that are not its options: lists of values, keys of a scene, and what
/// `study` has computed.
constexpr std::string_view read_elsewhere[] = {"sweep", "passage", "wheelset", "influence"};

/// The scene file of a parsed command; "" where it has none, or something else in its place.
std::string scene_of(const CLI::App& line) {
  for (const char* name : {"scene", "input"})
    if (const CLI::Option* option = line.get_option_no_throw(name); option && option->count() > 0)
      if (const std::string file = option->results().front(); is_regular(file) && !is_hdf5(file))
        return file;
  return "";
}

std::string key_of(const CLI::Option& option) {
  return option.get_lnames().empty() ? "" : table_name(option.get_lnames().front());
}

/// The options that a scene may give, by their keys.
std::vector<std::pair<std::string, CLI::Option*>> options_of(CLI::App& line) {
  std::vector<std::pair<std::string, CLI::Option*>> out;
  for (CLI::Option* option : line.get_options())
    if (const std::string key = key_of(*option); !key.empty() && option->get_configurable())
      out.emplace_back(key, option);
  return out;
}

/// The values as a command line would give them; none of what is no value.
std::vector<std::string> values_of(const toml::node& node) {
  std::vector<std::string> out;
  const auto take = [&](const toml::node& one) {
    if (const auto* text = one.as_string())
      out.push_back(text->get());
    else if (const auto* flag = one.as_boolean())
      out.push_back(flag->get() ? "true" : "false");
    else if (const auto* whole = one.as_integer())
      out.push_back(fmt::format("{}", whole->get()));
    else if (const auto* number = one.as_floating_point())
      out.push_back(fmt::format("{}", number->get()));
  };
  if (const toml::array* list = node.as_array())
    for (const toml::node& one : *list)
      take(one);
  else
    take(node);
  return out;
}

/// Whether a key of a command's table says something else: the wear map, and the lists of [table].
bool is_of_scene(const std::string& table, const std::string& key, const toml::node& node) {
  if (table == "table")
    return node.is_table() || node.is_array();
  const std::vector<std::string> keys = keys_of_table(table);
  return std::ranges::find(keys, key) != keys.end();
}

/// Reads one table. `given`: whether its values are taken; else they are looked at alone.
void take_table(CLI::App& line, const toml::table& values, const std::string& source, bool given) {
  const std::string table = table_name(line.get_name());
  const auto options = options_of(line);
  for (const auto& [name, node] : values) {
    const std::string key(name.str());
    if (is_of_scene(table, key, node))
      continue;
    const std::string where = fmt::format("{}:{}: ", source, name.source().begin.line);
    const auto option = std::ranges::find(options, key, &std::pair<std::string, CLI::Option*>::first);
    if (option == options.end() || !given || option->second->count() > 0) // the scene's reader knows all keys
      continue;
    try {
      const bool names_file = option->second->get_type_name() == file_option;
      for (const std::string& value : values_of(node))
        option->second->add_result(
            names_file ? absolute_name(value, std::filesystem::path(source).parent_path()) : value);
      if (option->second->count() == 0)
        throw CLI::ValidationError("it is no value");
      option->second->run_callback();
    } catch (const CLI::Error& error) {
      throw InputError(fmt::format("{}{}.{} cannot be used", where, table, key), error.what(),
                       fmt::format("See bem_contact {} --help.", line.get_name()));
    }
  }
}

} // namespace

std::string table_name(std::string command) {
  std::ranges::replace(command, '-', '_');
  return command;
}

void take_options_of_scene(const Command& command, const std::vector<Command>& all) {
  const std::string file = scene_of(*command.line);
  if (file.empty())
    return;
  toml::table root;
  try {
    root = parse_toml(read_text_file(file, "scene file"), file);
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
    return;
  }
  for (const Command& one : all) {
    const std::string table = table_name(one.line->get_name());
    const toml::table* values = root[table].as_table();
    if (values && std::ranges::count(read_elsewhere, table) == 0)
      take_table(*one.line, *values, file, one.line == command.line);
  }
}

void require_repeated_program(const SceneText& scene, const char* table, const char* key,
                              const std::string& repeated) {
  std::optional<std::string> named;
  try {
    named = parse_toml(scene.toml, scene.source)[table][key].value<std::string>();
  } catch (const toml::parse_error&) { // whoever reads the scene says what is wrong
  }
  if (named && *named != repeated)
    throw InputError(
        fmt::format("The scene names the program '{}' in {}.{}", *named, table, key),
        "a scene may be anybody's, and starts no program that you do not name yourself",
        fmt::format("Give --influence '{}' if it shall be started, or leave the key out.", *named));
}

} // namespace bem_contact::app
