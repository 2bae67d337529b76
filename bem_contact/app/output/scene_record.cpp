#include "bem_contact/app/output/scene_record.hpp"

#include "bem_contact/app/output/output_names.hpp"
#include "bem_contact/app/settings.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/profile/standard_profiles.hpp"

#include <algorithm>
#include <set>

namespace bem_contact::app {

namespace {

/// No folders of this machine.
std::string without_machine(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? path.filename().string() : name;
}

InputRecord record_of(const NamedFile& named) {
  if (!is_regular(named.file))
    return {named.key, without_machine(named.name), "not a regular file", {}};
  const std::string file = named.file.string();
  InputRecord out{named.key, without_machine(named.name), {}, {}};
  if (!names_influence(named.key) && std::filesystem::file_size(named.file) <= largest_kept_input)
    out.content = read_text_file(file, "input");
  out.sha256 = out.content ? sha256(*out.content) : sha256_of_file(file);
  if (out.content && out.content->find('\0') != std::string::npos) // a text in HDF5 ends there
    out.content.reset();
  return out;
}

} // namespace

GivenScene read_given_scene(const std::string& file, const std::string& model,
                            std::span<const SceneChange> changes) {
  const SceneText text = read_scene_text(file);
  return {text, model, with_model(parse_scene_file(text, changes), model), {}};
}

GivenScene read_given_scene_for(const std::vector<Output>& outputs, const std::string& file,
                                const std::string& model) {
  GivenScene out = read_given_scene(file, model);
  require_named_outputs(files_read(file, out.scene), outputs);
  if (std::ranges::any_of(outputs, [](const Output& output) {
        return output.form == OutputForm::whole_file && !output.file.empty();
      }))
    out.inputs = inputs_of(out.scene);
  return out;
}

std::vector<InputRecord> records_of(const std::vector<NamedFile>& files) {
  std::vector<InputRecord> inputs;
  for (const NamedFile& named : files) {
    const bool standard = names_profile(named.key) && is_standard_profile(named.name);
    inputs.push_back(standard ? InputRecord{named.key, named.name, "", {}} : record_of(named));
    if (named.key.ends_with(".body.profile")) {
      // The body file before it names it by a path that only its own folder gives a meaning.
      inputs.rbegin()[1].content.reset();
      inputs.back().content.reset();
    }
  }
  return inputs;
}

std::vector<InputRecord> inputs_of(const SceneFile& scene) {
  return records_of(named_files(scene));
}

std::vector<std::filesystem::path> files_read(const std::filesystem::path& file, const SceneFile& scene) {
  std::vector<std::filesystem::path> files = input_files(scene);
  files.push_back(file);
  return files;
}

void add_scene(H5Table& table, const GivenScene& given, const std::filesystem::path& output) {
  auto& a = table.attributes;
  a["program"] = provenance("bem_contact");
  a["commit"] = std::string(commit());
  a["scene"] = std::filesystem::path(given.text.source).filename().string();
  const auto target = std::filesystem::weakly_canonical(std::filesystem::absolute(output)).parent_path();
  const auto folder = std::filesystem::weakly_canonical(std::filesystem::absolute(given.text.folder / "."));
  a["scene_folder"] = folder.lexically_proximate(target).generic_string();
  a["model_option"] = given.model;
  table.texts["scene_text"] = {given.text.toml, "the scene as it was given (TOML)"};
  table.texts["scene_with_defaults"] = {scene_with_defaults(given.scene),
                                        "every key of the scene that was solved, with its value (TOML)"};
  const auto material = [&](const std::string& side, const Material& m) {
    table.datasets["materials/" + side + "_shear_modulus"] = H5Dataset::single(m.shear_modulus, "MPa", "G");
    table.datasets["materials/" + side + "_poisson"] = H5Dataset::single(m.poisson, "1", "Poisson's ratio");
  };
  material("rail", given.scene.rail.material);
  material("wheel", given.scene.wheel.material);
  for (const InputRecord& input : given.inputs) {
    const std::string group = "inputs/" + input.key + "/";
    table.attributes[group + "name"] = input.name;
    table.attributes[group + "sha256"] = input.sha256;
    if (input.content)
      table.texts[group + "content"] = {*input.content, "the file " + input.name};
  }
}

H5Table file_of(const char* format, const GivenScene& given, const std::filesystem::path& output) {
  H5Table table;
  table.attributes["format"] = std::string(format);
  add_scene(table, given, output);
  return table;
}

std::vector<InputRecord> stored_inputs(const H5Table& table) {
  std::set<std::string> keys;
  for (const auto& [name, value] : table.attributes)
    if (name.starts_with("inputs/") && name.ends_with("/name"))
      keys.insert(name.substr(7, name.size() - 12));
  std::vector<InputRecord> inputs;
  for (const std::string& key : keys) {
    const std::string group = "inputs/" + key + "/";
    InputRecord input{
        key, text_attribute(table, group + "name"), text_attribute(table, group + "sha256"), {}};
    if (const auto content = table.texts.find(group + "content"); content != table.texts.end())
      input.content = content->second.text;
    inputs.push_back(std::move(input));
  }
  return inputs;
}

} // namespace bem_contact::app
