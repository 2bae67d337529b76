#include "bem_contact/sequence/scene_record.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/provenance.hpp"
#include "bem_contact/base/sha256.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/sequence/section_lines.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

/// Bytes. A larger input is not kept in result files, only its digest. A measured profile has 100 kB; a step
/// table of 100000 rows has 5 MB.
constexpr std::uintmax_t largest_kept_input = 10'000'000;

/// No folders of this machine.
std::string without_machine(const std::string& name) {
  const std::filesystem::path path(name);
  return path.is_absolute() ? path.filename().string() : name;
}

/// Without links; as it stands where a folder may not be entered.
std::filesystem::path whole_name(const std::filesystem::path& file) {
  std::error_code failed;
  const std::filesystem::path from_root = std::filesystem::absolute(file, failed);
  std::filesystem::path whole = std::filesystem::weakly_canonical(from_root, failed);
  return failed ? from_root.lexically_normal() : whole;
}

InputRecord record_of(const NamedFile& named) {
  if (!is_regular(named.file))
    return {named.key, without_machine(named.name), "not a regular file", {}};
  const std::string file = named.file.string();
  InputRecord out{named.key, without_machine(named.name), {}, {}};
  std::error_code unknown;
  if (!names_influence(named.key) && std::filesystem::file_size(named.file, unknown) <= largest_kept_input)
    out.content = read_bytes(file, "input"); // as its digest has it
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

std::vector<InputRecord> records_of(const std::vector<NamedFile>& files) {
  std::vector<InputRecord> inputs;
  for (const NamedFile& named : files) {
    const bool standard = names_profile(named.key) && is_standard_profile(named.name);
    inputs.push_back(standard ? InputRecord{named.key, named.name, "", {}} : record_of(named));
    const std::string_view by = named_by(named.key);
    if (by.empty())
      continue;
    // The file before it names it by a path that only its own folder gives a meaning.
    inputs.back().content.reset();
    for (InputRecord& before : inputs)
      if (before.key == by)
        before.content.reset();
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

record::Record headed(const char* format) {
  return {{"format", record::Text{format}},
          {"program", record::Text{provenance("bem_contact")}},
          {"commit", record::Text{std::string(commit())}}};
}

record::Record headed(const char* format, const GivenScene& given, const std::filesystem::path& output) {
  using record::Number;
  using record::Text;
  const auto target = whole_name(output).parent_path(), folder = whole_name(given.text.folder / ".");
  record::Record materials, inputs;
  const auto material = [&](const std::string& side, const Material& m) {
    materials.add(side + "_shear_modulus", Number{m.shear_modulus, "MPa", "G"});
    materials.add(side + "_poisson", Number{m.poisson, "1", "Poisson's ratio"});
  };
  material("rail", given.scene.rail.material);
  material("wheel", given.scene.wheel.material);
  for (const InputRecord& input : given.inputs) {
    record::Record one{{"name", Text{input.name}}, {"sha256", Text{input.sha256}}};
    if (input.content)
      one.add("content", Text{*input.content, "the file " + input.name});
    inputs.add(input.key, std::move(one));
  }
  record::Record out = headed(format);
  out.add("scene", std::filesystem::path(given.text.source).filename().string());
  out.add("scene_folder", folder.lexically_proximate(target).generic_string());
  out.add("model_option", given.model);
  out.add("scene_text", Text{given.text.toml, "the scene as it was given (TOML)"});
  out.add("scene_with_defaults", Text{scene_with_defaults(given.scene),
                                      "every key of the scene that was solved, with its value (TOML)"});
  out.add("materials", std::move(materials));
  out.add("inputs", std::move(inputs));
  try {
    if (auto lines = section_lines(given.scene, "the scene"))
      out.add("section_lines", std::move(lines->points));
  } catch (const InputError&) { // the cases say what is wrong with the sections
  }
  return out;
}

namespace {

/// Adds the inputs below a group. A key is a path: what is no key of a scene is for the reader to refuse.
void add_inputs(const record::Record& group, const std::string& path, std::vector<InputRecord>& inputs) {
  for (const record::Entry& entry : group.entries()) {
    const auto* one = std::get_if<record::Record>(&entry.content);
    if (!one)
      continue;
    const auto text = [&](const char* name) { return record::text_at(*one, name); };
    if (text("name"))
      inputs.push_back({path + entry.name, std::string(*text("name")),
                        std::string(text("sha256").value_or("")),
                        text("content") ? std::optional<std::string>(*text("content")) : std::nullopt});
    add_inputs(*one, path + entry.name + "/", inputs);
  }
}

} // namespace

std::vector<InputRecord> stored_inputs(const record::Record& file) {
  std::vector<InputRecord> inputs;
  const record::Content* content = record::find(file, "inputs");
  if (const auto* all = content ? std::get_if<record::Record>(content) : nullptr)
    add_inputs(*all, "", inputs);
  return inputs;
}

} // namespace bem_contact
