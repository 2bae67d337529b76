#include "bem_contact/app/command.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/printable.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/scene_file.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

namespace bem_contact::app {

namespace {

using json = nlohmann::ordered_json;

constexpr const char* schema_help =
    R"(Lists the keys of a scene: type, unit, range, default and meaning. Example:
    bem_contact schema layer
You should see the keys of the table [layer], as layer.compliance in mm3/N.

With --json it is a JSON Schema of scenes. Editors that know TOML complete keys and mark wrong values with it:
    bem_contact schema --json > scene.schema.json
Then write as the first line of a scene (taplo, "Even Better TOML" in VS Code):
    #:schema ./scene.schema.json)";

/// JSON Schema's word.
const char* json_type(KeyType type) {
  switch (type) {
  case KeyType::number:
    return "number";
  case KeyType::whole_number:
    return "integer";
  case KeyType::flag:
    return "boolean";
  case KeyType::point:
  case KeyType::numbers:
  case KeyType::tables:
    return "array";
  default:
    return "string";
  }
}

json range_of(const KeyRule& rule) {
  json out = json::object();
  for (const auto& [name, bound] : {std::pair{"minimum", rule.at_least},
                                    {"exclusiveMinimum", rule.above},
                                    {"maximum", rule.at_most},
                                    {"exclusiveMaximum", rule.below}})
    if (std::isfinite(bound))
      out[name] = bound;
  return out;
}

/// "lateral displacement of the wheelset (mm)"
std::string described(const KeyDescription& key) {
  std::string out = key.doc;
  if (!key.rule.unit.empty())
    out += fmt::format(" ({})", key.rule.unit);
  if (!key.rule.kinds.empty())
    out += fmt::format(" [kind = {}]", fmt::join(key.rule.kinds, " or "));
  return out;
}

json object_of(const std::vector<KeyDescription>& keys, std::size_t skipped);

json json_of(const KeyDescription& key) {
  json out{{"description", described(key)}, {"type", json_type(key.type)}};
  if (!key.rule.unit.empty())
    out["unit"] = key.rule.unit;
  const json range = range_of(key.rule);
  if (key.type == KeyType::point || key.type == KeyType::numbers) {
    out["items"] = json{{"type", "number"}};
    out["items"].update(range);
  } else
    out.update(range);
  if (key.type == KeyType::point)
    out["minItems"] = out["maxItems"] = 2;
  if (key.type == KeyType::choice)
    out["enum"] = key.choices;
  if (key.type == KeyType::choices) { // names with commas between, or a list of them
    out["type"] = {"string", "array"};
    out["items"] = json{{"enum", key.choices}};
    out["choices"] = key.choices;
  }
  if (key.type == KeyType::tables)
    out["items"] = object_of(key.columns, key.path.size() + 1);
  if (key.value)
    std::visit([&](const auto& value) { out["default"] = value; }, *key.value);
  return out;
}

/// The object in which the last part of `path` is a key.
json& place_of(json& root, std::string_view path) {
  json* at = &root;
  for (std::size_t dot; (dot = path.find('.')) != path.npos; path.remove_prefix(dot + 1)) {
    json& table = (*at)["properties"][std::string(path.substr(0, dot))];
    if (table.is_null())
      table = json{{"type", "object"}, {"additionalProperties", false}, {"properties", json::object()}};
    at = &table;
  }
  return (*at)["properties"];
}

/// `skipped`: characters of each path that name the object itself.
json object_of(const std::vector<KeyDescription>& keys, std::size_t skipped) {
  json out{{"type", "object"}, {"additionalProperties", false}, {"properties", json::object()}};
  const auto add = [&](std::string_view path, json one) {
    path.remove_prefix(skipped);
    place_of(out, path)[std::string(path.substr(path.rfind('.') + 1))] = std::move(one);
  };
  for (const KeyDescription& key : keys) {
    add(key.path, json_of(key));
    if (!key.rule.formerly.empty()) {
      json former = json_of(key);
      former["deprecated"] = true;
      former["description"] = fmt::format("Now called {}", key.path);
      add(key.rule.formerly, std::move(former));
    }
  }
  return out;
}

/// Options of commands in a scene. What each command checks by itself is open here.
void add_commands(json& properties) {
  for (const std::string_view table : command_tables) {
    json& one = properties[std::string(table)];
    one = {{"type", "object"},
           {"description", table == "passage" ? "places along the track, for bem_contact sweep"
                                              : fmt::format("options of bem_contact {}", table)}};
    if (option_keys(table).empty() || table == "table") // any key of a scene
      continue;
    one["additionalProperties"] = false;
    for (const std::string_view key : option_keys(table))
      one["properties"][std::string(key)] = json::object();
  }
  for (const std::string_view key : option_keys("wear"))
    properties["wear"]["properties"].emplace(std::string(key), json::object());
}

json scene_schema_json() {
  json out{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "A scene of bem_contact"}};
  out.update(object_of(keys_of_scenes(), 0));
  add_commands(out["properties"]);
  return out;
}

std::string value_of(const SchemaValue& value) {
  return std::visit([](const auto& plain) { return json(plain).dump(); }, value);
}

/// "motion.friction: Coefficient of friction (number, 1; >= 0; default 0.3)"
std::string line_of(const KeyDescription& key) {
  std::vector<std::string> facts{json_type(key.type)};
  const auto bound = [&](const char* sign, double value) {
    if (std::isfinite(value))
      facts.push_back(fmt::format("{} {}", sign, value));
  };
  bound(">=", key.rule.at_least);
  bound(">", key.rule.above);
  bound("<=", key.rule.at_most);
  bound("<", key.rule.below);
  if (!key.choices.empty())
    facts.push_back(fmt::format("{}", fmt::join(key.choices, " | ")));
  if (key.value)
    facts.push_back("default " + value_of(*key.value));
  return fmt::format("{}: {} [{}]\n", key.path, described(key), fmt::join(facts, "; "));
}

/// `begin`: a table or a key; "": all.
std::string list_of_keys(const std::string& begin) {
  std::string out;
  std::vector<std::string> names;
  for (const KeyDescription& key : keys_of_scenes()) {
    if (begin.empty() || key.path == begin || key.path.starts_with(begin + "."))
      out += line_of(key);
    names.push_back(key.path);
  }
  if (!out.empty())
    return out;
  const auto like = nearest_names(begin, names, 1);
  throw InputError(fmt::format("There is no key or table '{}'", begin), "a scene has others",
                   like.empty() ? "See bem_contact schema for all of them."
                                : fmt::format("Did you mean {}?", like.front()));
}

} // namespace

Command add_schema(CLI::App& program) {
  CLI::App* line =
      program.add_subcommand("schema", "List the keys of a scene, or give a JSON Schema of them");
  const auto name = std::make_shared<std::string>();
  const auto as_json = std::make_shared<bool>(false);
  CLI::Option* key = line->add_option("key", *name, "A table or a key, as motion; without it all keys");
  line->add_flag("--json", *as_json, "Print a JSON Schema, with which editors complete scenes")
      ->excludes(key);
  line->footer(schema_help);
  return {line, [name, as_json] {
            print_out("{}", *as_json ? scene_schema_json().dump(2) + "\n" : list_of_keys(*name));
            return success;
          }};
}

} // namespace bem_contact::app
