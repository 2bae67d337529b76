#include "bem_contact/app/scene_record.hpp"

#include "bem_contact/app/settings.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/influence/file_seal.hpp"
#include "bem_contact/profile/body_file.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/scene_reader.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace bem_contact::app {

namespace {

constexpr std::size_t any_size = std::numeric_limits<std::size_t>::max() / 4;

bool is_influence(const std::string& key) {
  return key.ends_with(".influence");
}

/// No folders of this machine.
std::string without_machine(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? path.filename().string() : name;
}

/// The profile that a body file names, where it is a file.
std::optional<NamedFile> profile_of_body(const NamedFile& named) {
  if (named.file.extension() != ".toml" || !is_regular(named.file))
    return std::nullopt;
  const BodyFile body = read_body_file(named.file);
  const std::string& name = body.body.profile;
  if (name.empty() || is_standard_profile(name) || !file_exists(body.folder / name))
    return std::nullopt;
  return NamedFile{named.key + ".body.profile", name, body.folder / name};
}

bool is_profile(const std::string& key) {
  return key.ends_with(".profile");
}

void add_number(H5Table& table, const std::string& name, double value, const char* unit,
                const char* description) {
  table.datasets[name] = {{}, {value}, unit, description};
}

} // namespace

GivenScene read_given_scene(const std::string& file, const std::string& model) {
  GivenScene out{
      file, read_text_file(file, "scene file"), model, std::filesystem::path(file).parent_path(), {}, {}};
  out.scene = SceneReader(out.text, file, out.folder).scene();
  if (!model.empty())
    out.scene.solver.model = model_named(model);
  return out;
}

InputRecord record_of(const NamedFile& named) {
  if (!is_regular(named.file))
    return {named.key, without_machine(named.name), "not a regular file", {}};
  const std::string bytes = read_text_file(named.file.string(), "input", any_size);
  InputRecord out{named.key, without_machine(named.name), sha256(bytes), {}};
  // A text in HDF5 ends at its first NUL.
  const bool kept =
      !is_influence(named.key) && bytes.size() <= largest_kept_input && bytes.find('\0') == std::string::npos;
  if (kept)
    out.content = bytes;
  return out;
}

std::vector<InputRecord> inputs_of(const SceneFile& scene) {
  std::vector<InputRecord> inputs;
  for (const NamedFile& named : named_files(scene)) {
    if (is_profile(named.key) && is_standard_profile(named.name)) {
      inputs.push_back({named.key, named.name, "", {}});
      continue;
    }
    inputs.push_back(record_of(named));
    if (!is_profile(named.key))
      continue;
    if (const auto points = profile_of_body(named)) {
      inputs.back().content.reset(); // it names a file by a path that only its own folder gives a meaning
      inputs.push_back(record_of(*points));
      inputs.back().content.reset();
    }
  }
  return inputs;
}

void add_scene(H5Table& table, const GivenScene& given, const std::filesystem::path& output) {
  auto& a = table.attributes;
  a["program"] = provenance("bem_contact");
  a["commit"] = std::string(commit());
  a["scene"] = std::filesystem::path(given.source).filename().string();
  const auto target = std::filesystem::weakly_canonical(std::filesystem::absolute(output)).parent_path();
  const auto folder = std::filesystem::weakly_canonical(std::filesystem::absolute(given.folder / "."));
  a["scene_folder"] = folder.lexically_proximate(target).generic_string();
  a["model_option"] = given.model;
  table.texts["scene_text"] = {given.text, "the scene as it was given (TOML)"};
  table.texts["scene_with_defaults"] = {scene_with_defaults(given.scene),
                                        "every key of the scene that was solved, with its value (TOML)"};
  const auto material = [&](const std::string& side, const Material& m) {
    add_number(table, "materials/" + side + "_shear_modulus", m.shear_modulus, "MPa", "G");
    add_number(table, "materials/" + side + "_poisson", m.poisson, "1", "Poisson's ratio");
  };
  material("rail", given.scene.rail.material);
  material("wheel", given.scene.wheel.material);
  add_inputs(table, given.inputs);
}

void add_inputs(H5Table& table, const std::vector<InputRecord>& inputs) {
  for (const InputRecord& input : inputs) {
    const std::string group = "inputs/" + input.key + "/";
    table.attributes[group + "name"] = input.name;
    table.attributes[group + "sha256"] = input.sha256;
    if (input.content)
      table.texts[group + "content"] = {*input.content, "the file " + input.name};
  }
}

std::vector<InputRecord> stored_inputs(const H5Table& table) {
  const auto text = [&](const std::string& name) {
    const auto at = table.attributes.find(name);
    const auto* found = at == table.attributes.end() ? nullptr : std::get_if<std::string>(&at->second);
    return found ? *found : std::string();
  };
  std::set<std::string> keys;
  for (const auto& [name, value] : table.attributes)
    if (name.starts_with("inputs/") && name.ends_with("/name"))
      keys.insert(name.substr(7, name.size() - 12));
  std::vector<InputRecord> inputs;
  for (const std::string& key : keys) {
    const std::string group = "inputs/" + key + "/";
    InputRecord input{key, text(group + "name"), text(group + "sha256"), {}};
    if (const auto content = table.texts.find(group + "content"); content != table.texts.end())
      input.content = content->second.text;
    inputs.push_back(std::move(input));
  }
  return inputs;
}

} // namespace bem_contact::app
