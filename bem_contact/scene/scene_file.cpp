#include "bem_contact/scene/scene_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/command_tables.hpp"
#include "bem_contact/scene/directly_named.hpp"
#include "bem_contact/scene/scene_keys.hpp"
#include "bem_contact/scene/scene_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

/// A scene whose keys without a default have examples.
SceneFile example_scene() {
  SceneFile file;
  file.rail.profile = "60E1";
  file.wheel.profile = "S1002";
  file.load.force = 1e5;
  return file;
}

/// `as_read` holds what `schema` is bound to.
SceneFile checked(const SceneFile& as_read, const SceneKeysAsRead& read, const Schema& schema) {
  SceneFile file = as_read;
  settle(file, schema, read);
  check_keys(file, schema);
  file.unused = unused_keys(file, schema);
  return file;
}

/// The file that an element of a list of sections names, as "rail.sections[3].profile" (directly_named());
/// null: the key is none of them.
std::string* file_of_section(SceneFile& scene, const std::string& key) {
  for (const auto& [name, side] : {std::pair{"rail", &scene.rail}, {"wheel", &scene.wheel}})
    for (std::size_t i = 0; i < side->sections.size(); ++i) {
      const std::string path = fmt::format("{}.sections[{}].", name, i);
      if (key.starts_with(path))
        return key == path + "profile"     ? &side->sections[i].profile
               : key == path + "influence" ? &side->sections[i].influence
                                           : nullptr;
    }
  return nullptr;
}

} // namespace

/// The schema is bound to the two members before it, which therefore stay where they are.
struct SceneReader::State {
  SceneFile file;
  SceneKeysAsRead read;
  Schema schema = scene_schema(file, read);

  State(const SceneText& given, std::span<const SceneChange> changes) {
    file.folder = given.folder;
    for (const std::string_view table : command_tables)
      schema.skip(std::string(table));
    schema.share("wear");
    schema.read(given.toml, given.source);
    for (const SceneChange& change : changes)
      set(change);
  }

  void set(const SceneChange& change) {
    std::string* of_section = file_of_section(file, change.key);
    if (const auto* text = std::get_if<std::string>(&change.value); of_section && text)
      *of_section = *text;
    else
      schema.set(change.key, change.value, change.line, change.source);
  }
};

SceneReader::SceneReader(SceneText given)
    : given_(std::move(given)), state_(std::make_unique<State>(given_, changes_)) {
  require_known_options(given_);
}

SceneReader::~SceneReader() = default;
SceneReader::SceneReader(SceneReader&&) noexcept = default;

void SceneReader::set(const SceneChange& change) {
  try {
    state_->set(change);
  } catch (...) { // the schema may have taken half of it
    state_ = std::make_unique<State>(given_, changes_);
    throw;
  }
  const auto known = std::ranges::find(changes_, change.key, &SceneChange::key);
  known == changes_.end() ? changes_.push_back(change) : void(known->value = change.value);
}

void SceneReader::set_number(const std::string& key, double number) {
  set({key, state_->schema.number_for(key, number)});
}

void SceneReader::reset() {
  changes_.clear();
  state_ = std::make_unique<State>(given_, changes_);
}

void SceneReader::require_key(const std::string& key) const {
  if (!file_of_section(state_->file, key))
    state_->schema.number_for(key, 0);
}

SceneFile SceneReader::scene() const {
  SceneFile file = checked(state_->file, state_->read, state_->schema);
  const auto beside = [&](std::string_view table) { // a scene for bem_contact study, which answers all tables
    return std::ranges::any_of(
        command_tables, [&](std::string_view other) { return other != table && state_->schema.has(other); });
  };
  if (changes_.empty()) // a case of a sweep has changes
    for (const auto& [table, command] :
         {std::pair{"sweep", "sweep"}, {"passage", "sweep"}, {"table", "table"}})
      if (state_->schema.has(table) && !beside(table))
        file.unused.push_back(
            {WarningKind::without_effect,
             fmt::format("[{}]: one case is solved here, that of the other keys; bem_contact {} "
                         "solves all, and bem_contact study both",
                         table, command),
             table});
  return file;
}

void SceneReader::require_effect(std::span<const std::string> swept) const {
  const SceneFile file = checked(state_->file, state_->read, state_->schema);
  for (const OverruledKey& one : overruled_keys(file, state_->schema))
    if (std::ranges::find(swept, one.key) != swept.end())
      state_->schema.refuse(one.key, fmt::format("{}: all cases would be the same", one.why), one.what_to_do);
}

SceneText read_scene_text(const std::filesystem::path& file) {
  return {read_text_file(file.string(), "scene file"), file.string(), file.parent_path()};
}

SceneFile parse_scene_file(SceneText given, std::span<const SceneChange> changes) {
  SceneReader reader(std::move(given));
  for (const SceneChange& change : changes)
    reader.set(change);
  return reader.scene();
}

SceneFile read_scene_file(const std::filesystem::path& file, std::span<const SceneChange> changes) {
  return parse_scene_file(read_scene_text(file), changes);
}

SceneFile with_model(SceneFile scene, std::optional<Model> model) {
  scene.solver.model = model;
  return scene;
}

SceneFile with_model(SceneFile scene, const std::string& name) {
  return name.empty() ? scene : with_model(std::move(scene), model_named(name));
}

SceneFile with_lateral(SceneFile scene, double lateral) {
  scene.position.lateral = lateral;
  scene.load.force_y.reset();
  return scene;
}

SceneFile one_wheel(SceneFile scene, WheelSide side) {
  const SceneFile::Wheelset given = std::exchange(scene.wheelset, {});
  scene.position.side = side;
  if (side == WheelSide::right)
    return scene;
  for (const auto& [body, left] :
       {std::pair(&scene.rail, &given.left_rail), {&scene.wheel, &given.left_wheel}})
    if (!left->profile.empty()) {
      body->profile = left->profile;
      body->sections.clear();
      body->bodies.clear();
      body->reading = left->reading;
      body->influence = left->influence;
    }
  scene.position.rail_inclination = given.left_rail_inclination.value_or(scene.position.rail_inclination);
  scene.motion.friction = given.left_friction.value_or(scene.motion.friction);
  scene.position.wheel_radius = given.left_wheel_radius.value_or(scene.position.wheel_radius);
  return scene;
}

SceneFile with_elements(SceneFile scene, double dx, double ds) {
  scene.grid.dx = dx;
  scene.grid.ds = ds;
  scene.grid.elements.reset();
  scene.grid.accuracy.reset();
  return scene;
}

bool names_profile(std::string_view key) {
  return key.ends_with("profile");
}

bool names_influence(std::string_view key) {
  return key.ends_with("influence");
}

std::string_view named_by(std::string_view key) {
  const std::size_t body = key.rfind(".body.profile"), slice = key.rfind(".profile.sections[");
  return body != key.npos ? key.substr(0, body) : slice != key.npos ? key.substr(0, slice + 8) : "";
}

std::vector<NamedFile> files_of_key(const std::string& key, const std::string& name,
                                    const std::filesystem::path& folder) {
  if (name.empty())
    return {};
  if (!names_profile(key))
    return {{key, name, folder / name}};
  std::vector<NamedFile> files{{key, name, profile_file_name(name, folder).file}};
  const std::filesystem::path file = files.front().file;
  if (names_slices(name) && is_regular(file)) {
    try {
      for (const Slice& slice : read_slices(file).slices) {
        const std::string written = slice.profile.string();
        files.push_back({fmt::format("{}.sections[{}].profile", key, files.size() - 1),
                         is_standard_profile(written)
                             ? written
                             : slice.profile.lexically_proximate(file.parent_path()).generic_string(),
                         slice.profile});
      }
    } catch (const InputError&) { // whoever uses the sections says what is wrong with them
    }
    return files;
  }
  if (is_standard_profile(name) || file.extension() != ".toml" || !is_regular(file))
    return files;
  try {
    const BodyFile body = read_body_file(file);
    if (const std::filesystem::path points = profile_file_of(body); file_exists(points))
      files.push_back({key + ".body.profile", body.body.profile, points});
  } catch (const InputError&) { // whoever uses the body says what is wrong with it
  }
  return files;
}

std::vector<NamedFile> named_files(const SceneFile& scene) {
  std::vector<NamedFile> files;
  for (const NamedFile& named : directly_named(scene))
    std::ranges::move(files_of_key(named.key, named.name, scene.folder), std::back_inserter(files));
  return files;
}

std::vector<std::filesystem::path> paths_of(const std::vector<NamedFile>& files) {
  std::vector<std::filesystem::path> paths;
  for (const NamedFile& named : files)
    paths.push_back(named.file);
  return paths;
}

std::vector<std::filesystem::path> input_files(const SceneFile& scene) {
  return paths_of(named_files(scene));
}

std::string default_scene_file() {
  SceneFile file = example_scene();
  SceneKeysAsRead read;
  return scene_schema(file, read).print();
}

std::vector<KeyDescription> keys_of_scenes() {
  SceneFile file;
  SceneKeysAsRead read;
  return scene_schema(file, read).describe();
}

std::string unit_of_key(std::string_view key) {
  SceneFile file;
  SceneKeysAsRead read;
  return scene_schema(file, read).unit(key);
}

std::vector<std::string> keys_of_table(std::string_view table) {
  SceneFile file;
  SceneKeysAsRead read;
  return scene_schema(file, read).keys_of(table);
}

std::string scene_with_defaults(const SceneFile& scene) {
  SceneFile file = example_scene();
  SceneKeysAsRead read;
  const Schema schema = scene_schema(file, read); // remembers the defaults; stays bound to `file` and `read`
  file = scene;
  read.rail_young = scene.rail.material.young();
  read.wheel_young = scene.wheel.material.young();
  if (scene.grid.rows) {
    read.s_from = scene.grid.rows->from;
    read.s_to = scene.grid.rows->to;
  }
  for (SceneFile::Side* side : {&file.rail, &file.wheel})
    if (!side->sections.empty()) // the first of them is its profile
      side->profile.clear();
  return schema.print();
}

} // namespace bem_contact
