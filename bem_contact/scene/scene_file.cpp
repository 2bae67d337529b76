#include "bem_contact/scene/scene_file.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/accuracy_of.hpp"
#include "bem_contact/scene/check_friction.hpp"
#include "bem_contact/scene/check_wheelset.hpp"
#include "bem_contact/scene/scene_keys.hpp"
#include "bem_contact/scene/scene_reader.hpp"
#include "bem_contact/scene/unused_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace bem_contact {

namespace {

void check_load(const SceneFile& f, const Schema& s) {
  const int given = f.load.force.has_value() + f.load.approach.has_value() + f.position.vertical.has_value();
  if (given > 1)
    s.refuse(f.position.vertical ? "position.vertical" : "load.approach",
             f.load.force ? "load.force is given too" : "load.approach is given too",
             f.position.vertical ? "Give exactly one of load.force, load.approach and position.vertical."
                                 : "Give exactly one of load.force and load.approach.");
  if (given == 0)
    s.refuse("load", "neither force nor approach is given",
             s.has("sweep")   ? "Give load.force or load.approach; a scene whose table [sweep] does is for "
                                "bem_contact sweep."
             : s.has("table") ? "Give load.force or load.approach; a scene whose table [table] does is for "
                                "bem_contact table."
                              : "Give load.force or load.approach.");
  if (f.load.force_y && !f.load.force)
    s.refuse("load.force_y",
             "the lateral displacement is sought under a vertical force, and load.force is not given",
             "Give load.force instead of the approach.");
}

void check_motion(const SceneFile& f, const Schema& s) {
  if (!f.motion.frictionless && f.motion.friction == 0)
    s.refuse("motion.friction", "zero friction leaves nothing to roll on",
             "Set motion.frictionless = true for the normal problem alone, or give friction > 0.");
  const std::pair<const char*, double> rates[] = {{"motion.pitch_rate", f.motion.pitch_rate.value_or(0)},
                                                  {"motion.lateral_velocity", f.motion.lateral_velocity},
                                                  {"motion.vertical_velocity", f.motion.vertical_velocity},
                                                  {"motion.roll_rate", f.motion.roll_rate},
                                                  {"motion.yaw_rate", f.motion.yaw_rate}};
  for (const auto& [key, rate] : rates) {
    if (rate != 0 && !f.motion.speed)
      s.refuse(key, "only its ratio to the forward speed counts, and motion.speed is not given",
               "Give motion.speed too.");
    if (rate != 0 && f.motion.kind == MotionKind::shift)
      s.refuse(key, "a shift has no velocities", "Give xi, eta and phi.");
  }
  if (f.motion.pitch_rate && f.motion.rolling_radius)
    s.refuse("motion.rolling_radius", "pitch_rate is given too",
             "Give either the rolling radius or both speed and pitch_rate.");
  if (!f.motion.slip_table.empty() && (f.motion.xi != 0 || f.motion.eta != 0 || f.motion.phi != 0))
    s.refuse("motion.slip_table", "creepages are given too", "Give either the table or xi, eta and phi.");
}

void check_steps(const SceneFile& f, const Schema& s) {
  const bool steps = f.motion.steps > 1 || !f.motion.step_table.empty() || !f.motion.start_table.empty();
  if (steps && f.motion.kind == MotionKind::steady)
    s.refuse("motion.kind", "steady rolling has no steps",
             "Choose transient or shift, or leave out the steps.");
  if (steps && f.motion.frictionless)
    s.refuse("motion.frictionless", "without friction nothing remembers a step",
             "Leave out the steps, or give friction.");
  if (f.motion.steps > 1 && !f.motion.step_table.empty())
    s.refuse("motion.steps", "the step table has a row for each step", "Give either of the two.");
  if ((f.load.force_x || f.load.force_s) && f.motion.frictionless)
    s.refuse("load", "without friction there is no shear force", "Leave out force_x and force_s.");
  if (f.load.force_y && f.motion.kind != MotionKind::steady && !f.motion.frictionless)
    s.refuse("load.force_y", "the lateral displacement would be another one at each step",
             "Choose motion.kind = \"steady\", or give position.lateral.");
  if (f.motion.from_free_rolling && f.motion.kind != MotionKind::steady)
    s.refuse("motion.from_free_rolling", "free rolling is steady", "Choose motion.kind = \"steady\".");
  if (f.motion.from_free_rolling && f.load.force_x)
    s.refuse("motion.from_free_rolling", "load.force_x is given, and its creepage is found",
             "Leave out one of the two.");
  if (f.motion.friction_table.empty() && f.motion.kinetic_friction.value_or(0) > f.motion.friction)
    s.refuse("motion.kinetic_friction", fmt::format("friction in adhesion is only {}", f.motion.friction),
             "Give a smaller coefficient.");
}

void check_patch(const SceneFile& f, const Schema& s) {
  if (!f.grid.mx)
    s.refuse("grid.mx", "a patch needs its number of elements along x", "Give grid.mx >= 1.");
  if (!f.grid.ms)
    s.refuse("grid.ms", "a patch needs its number of elements along s", "Give grid.ms >= 1.");
  if (f.grid.plane_strain && f.grid.mx != 1)
    s.refuse("grid.mx", "plane strain has one element, infinitely long along x", "Give grid.mx = 1.");
  if (f.grid.plane_strain && !f.motion.frictionless)
    s.refuse("grid.plane_strain", "rolling and shifts need elements along x",
             "Set motion.frictionless = true, or leave it out.");
  if (!f.gap.table.empty() && (f.gap.a != 0 || f.gap.b != 0 || f.gap.c != 0))
    s.refuse("gap.table", "quadratic coefficients are given too", "Give either the table or a, b and c.");
  if (!f.strip.inclination.empty() && f.strip.radius != 0)
    s.refuse("strip.inclination", "strip.radius is given too", "Give either the table or the radius.");
  if (f.strip.upper_radius != 0 && f.strip.radius == 0)
    s.refuse("strip.upper_radius", "it makes a gap between two circles, and strip.radius is not given",
             "On a flat strip give the gap: gap.b = 1/2 over the radius.");
}

void check_wheel_rail(const SceneFile& f, const Schema& s) {
  accuracy_of(f.grid.accuracy_of);
  if (f.rail.profile.empty())
    s.refuse("rail.profile", "a wheel on a rail needs the rail's profile",
             "Give for instance profile = \"60E1\".");
  if (f.wheel.profile.empty())
    s.refuse("wheel.profile", "a wheel on a rail needs the wheel's profile",
             "Give for instance profile = \"S1002\".");
  const bool by_gauge = f.rail.place == BodyPlace::gauge && f.wheel.place == BodyPlace::gauge;
  if (f.wheel.place == BodyPlace::absolute && f.wheel.reading.flange_back)
    s.refuse("wheel.flange_back", "wheel.place = \"absolute\" keeps the file's origin",
             "Leave out flange_back, or place the wheel by its flange.");
  if (by_gauge && f.position.back_to_back >= f.position.gauge) {
    if (!s.has("position.back_to_back"))
      s.refuse("position.gauge", fmt::format("the flange backs are {} mm apart", f.position.back_to_back),
               "Give the gauge in mm, and position.back_to_back if it is another one.");
    s.refuse("position.back_to_back", fmt::format("the gauge is only {} mm", f.position.gauge),
             "Give a distance between the flange backs smaller than the gauge.");
  }
  if ((f.grid.elements || f.grid.accuracy) && (f.grid.mx || f.grid.ms))
    s.refuse(f.grid.accuracy ? "grid.accuracy" : "grid.elements", "the numbers mx or ms are given too",
             "Leave out grid.mx and grid.ms.");
  if ((f.grid.elements || f.grid.accuracy) && f.motion.kind != MotionKind::steady)
    s.refuse(f.grid.accuracy ? "grid.accuracy" : "grid.elements",
             "a transient needs one grid for all its steps", "Give grid.dx and grid.ds.");
  if (f.grid.rows && f.grid.ms)
    s.refuse("grid.ms", "grid.s_from and grid.s_to say where the rows begin and end",
             "Leave out grid.ms, or s_from and s_to.");
  if (f.grid.rows && f.grid.rows->to <= f.grid.rows->from)
    s.refuse("grid.s_to",
             fmt::format("the rows would run from {} to {} mm", f.grid.rows->from, f.grid.rows->to),
             "Give s_to greater than s_from, or leave both out.");
}

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
  check_wheelset(file, schema);
  if (!file.wheelset.force)
    check_load(file, schema);
  check_motion(file, schema);
  check_steps(file, schema);
  check_friction(file, schema);
  model_tolerance_of(file.solver.model_tolerance_of);
  if (file.kind == SceneKind::patch)
    check_patch(file, schema);
  else
    check_wheel_rail(file, schema);
  if (file.solver.model == Model::fem && file.rail.influence.empty() && file.wheel.influence.empty())
    schema.refuse("solver.model", "no influence file is given",
                  "Give rail.influence and wheel.influence, or use model = \"halfspace\".");
  file.unused = unused_keys(file, schema);
  return file;
}

} // namespace

/// The schema is bound to the two members before it, which therefore stay where they are.
struct SceneReader::State {
  SceneFile file;
  SceneKeysAsRead read;
  Schema schema = scene_schema(file, read);

  State(const SceneReader::Source& source, std::span<const SceneChange> changes) {
    file.folder = source.folder;
    schema.skip("sweep");
    schema.skip("table");
    schema.read(source.toml, source.name);
    for (const SceneChange& change : changes)
      schema.set(change.key, change.value, change.line);
  }
};

SceneReader::SceneReader(std::string_view toml, std::string_view source_name, std::filesystem::path folder)
    : source_{std::string(toml), std::string(source_name), std::move(folder)},
      state_(std::make_unique<State>(source_, changes_)) {}

SceneReader::~SceneReader() = default;
SceneReader::SceneReader(SceneReader&&) noexcept = default;

void SceneReader::set(const SceneChange& change) {
  try {
    state_->schema.set(change.key, change.value, change.line);
  } catch (...) { // the schema may have taken half of it
    state_ = std::make_unique<State>(source_, changes_);
    throw;
  }
  const auto known = std::ranges::find(changes_, change.key, &SceneChange::key);
  known == changes_.end() ? changes_.push_back(change) : void(known->value = change.value);
}

void SceneReader::set_number(const std::string& key, double number) {
  set({key, state_->schema.number_for(key, number)});
}

void SceneReader::require_key(const std::string& key) const {
  state_->schema.number_for(key, 0);
}

SceneFile SceneReader::scene() const {
  return checked(state_->file, state_->read, state_->schema);
}

SceneFile parse_scene_file(std::string_view toml, std::string_view source_name,
                           std::span<const SceneChange> changes) {
  SceneReader reader(toml, source_name, {});
  for (const SceneChange& change : changes)
    reader.set(change);
  return reader.scene();
}

SceneFile read_scene_file(const std::filesystem::path& path, std::span<const SceneChange> changes) {
  SceneFile file = parse_scene_file(read_text_file(path.string(), "scene file"), path.string(), changes);
  file.folder = path.parent_path();
  return file;
}

SceneFile with_model(SceneFile scene, std::optional<Model> model) {
  scene.solver.model = model;
  return scene;
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
  const auto differ = [](SceneFile::Side& body, const std::string& profile, const std::string& influence) {
    if (profile.empty())
      return;
    body.profile = profile;
    body.influence = influence;
  };
  differ(scene.rail, given.left_rail, given.left_rail_influence);
  differ(scene.wheel, given.left_wheel, given.left_wheel_influence);
  scene.motion.friction = given.left_friction.value_or(scene.motion.friction);
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

std::vector<NamedFile> files_of_key(const std::string& key, const std::string& name,
                                    const std::filesystem::path& folder) {
  if (name.empty())
    return {};
  if (!names_profile(key))
    return {{key, name, folder / name}};
  std::vector<NamedFile> files{{key, name, profile_file_name(name, folder).file}};
  const std::filesystem::path& file = files.front().file;
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
  const auto add = [&](const char* key, const std::string& name) {
    std::ranges::move(files_of_key(key, name, scene.folder), std::back_inserter(files));
  };
  add("rail.profile", scene.rail.profile);
  add("wheel.profile", scene.wheel.profile);
  add("wheelset.left_rail_profile", scene.wheelset.left_rail);
  add("wheelset.left_wheel_profile", scene.wheelset.left_wheel);
  add("wheelset.left_rail_influence", scene.wheelset.left_rail_influence);
  add("wheelset.left_wheel_influence", scene.wheelset.left_wheel_influence);
  add("rail.influence", scene.rail.influence);
  add("wheel.influence", scene.wheel.influence);
  add("gap.table", scene.gap.table);
  add("strip.inclination", scene.strip.inclination);
  add("motion.slip_table", scene.motion.slip_table);
  add("motion.friction_table", scene.motion.friction_table);
  add("motion.step_table", scene.motion.step_table);
  add("motion.start_table", scene.motion.start_table);
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

std::string unit_of_key(std::string_view key) {
  SceneFile file;
  SceneKeysAsRead read;
  return scene_schema(file, read).unit(key);
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
  return schema.print();
}

} // namespace bem_contact
