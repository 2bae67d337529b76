#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/scene/friction_laws.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace bem_contact {

namespace {

/// If `holds`, the keys have no effect, for the reason `why`.
struct Cause {
  std::vector<const char*> keys;
  bool holds;
  std::string why;
};

/// What rolling and friction need, and the normal problem alone does not.
std::vector<const char*> keys_of_friction(const SceneFile& f) {
  std::vector<const char*> keys{"motion.friction",
                                "motion.kinetic_friction",
                                "motion.friction_memory",
                                "motion.friction_table",
                                "motion.xi",
                                "motion.eta",
                                "motion.phi",
                                "motion.slip_table",
                                "motion.rolling_radius",
                                "motion.pitch_rate",
                                "motion.lateral_velocity",
                                "motion.vertical_velocity",
                                "motion.roll_rate",
                                "motion.yaw_rate",
                                "motion.from_free_rolling",
                                "motion.free_rolling",
                                "motion.radial_displacement",
                                "temperature.flash",
                                "layer.state",
                                "layer.compliance",
                                "layer.shear_modulus",
                                "layer.thickness",
                                "layer.table",
                                "layer.yield_shear",
                                "layer.yield_temperatures",
                                "layer.yield_shears",
                                "layer.hardening",
                                "motion.roller_speed",
                                "motion.wheel_forward_velocity",
                                "motion.wheel_lateral_velocity",
                                "motion.wheel_vertical_velocity",
                                "motion.wheel_roll_rate",
                                "motion.wheel_pitch_rate",
                                "motion.wheel_yaw_rate"};
  if (!f.wheelset.force || !f.track.curve_radius) // an axle has a lateral force there
    keys.insert(keys.begin() + 8, {"motion.speed", "track.curve_radius"});
  return keys;
}

std::vector<Cause> causes_of_motion(const SceneFile& f) {
  const SceneFile::Motion& m = f.motion;
  const bool rates = m.pitch_rate || m.lateral_velocity != 0 || m.vertical_velocity != 0 ||
                     m.roll_rate != 0 || m.yaw_rate != 0 || f.track.curve_radius || m.roller_speed ||
                     m.wheel != SceneFile::Motion::WheelRates{};
  const bool falls = asked_law(m) || !m.friction_table.empty();
  std::vector<Cause> causes{
      {keys_of_friction(f), m.frictionless, "motion.frictionless = true leaves the normal problem alone"},
      {{"motion.kind"},
       m.frictionless && m.kind != MotionKind::steady,
       "without friction nothing remembers a step"},
      {{"motion.friction"},
       !m.frictionless && !m.friction_table.empty(),
       "motion.friction_table is given instead"},
      {{"motion.speed", "motion.rolling_radius"},
       !m.frictionless && m.kind == MotionKind::shift,
       "bodies that are shifted do not roll"},
      {{"motion.speed"},
       !m.frictionless && m.kind != MotionKind::shift && !rates && !falls && !f.temperature.flash,
       "neither motion.pitch_rate nor a velocity is given beside it, and neither friction that falls with "
       "the slip velocity nor a temperature is asked for"},
      {{"temperature.rail", "temperature.wheel", "temperature.rail_conductivity",
        "temperature.wheel_conductivity", "temperature.rail_heat_capacity", "temperature.wheel_heat_capacity",
        "temperature.rail_density", "temperature.wheel_density", "temperature.rail_share"},
       !f.temperature.flash,
       "temperature.flash = true asks for temperatures"},
      {{"temperature.falls_from", "temperature.falls_to"},
       !f.temperature.hot_friction,
       "temperature.hot_friction is not given"},
  };
  for (const AskedLaw& law : friction_laws()) {
    const auto& [first, other] = law.numbers;
    for (const AskedLaw::Number& number : law.numbers)
      causes.front().keys.push_back(number.key);
    causes.push_back({{other.key}, !(m.*first.member), fmt::format("{} is not given", first.key)});
  }
  return causes;
}

std::vector<Cause> causes_of_bodies(const SceneFile& f) {
  const SceneFile::Motion& m = f.motion;
  const bool one_file = f.rail.has_influence() == f.wheel.influence.empty();
  return {
      {{"rail.structural"},
       f.rail.structural == StructuralCompliance::included && f.rail.influence.empty(),
       "it says which part of an influence file is taken, and there is no rail.influence"},
      {{"wheel.structural"},
       f.wheel.structural == StructuralCompliance::included && f.wheel.influence.empty(),
       "it says which part of an influence file is taken, and there is no wheel.influence"},
      {{"solver.structural_motion"},
       f.rail.structural == StructuralCompliance::removed &&
           f.wheel.structural == StructuralCompliance::removed,
       "no body's structural compliance is included"},
      {{"position.along"},
       !f.changes_along(),
       "none of wheel.flat, wheel.polygon, wheel.sections, rail.joint and rail.sections is given: wheel and "
       "rail are the same everywhere"},
      {{"wheel.sections_angle"}, !f.wheel.has_sections(), "wheel.sections is not given"},
      {{"track.superelevation", "track.base"},
       !f.wheelset.force,
       "an axle needs it, and wheelset.force is not given"},
      {{"track.base"}, f.wheelset.force && !f.track.curve_radius, "track.curve_radius is not given"},
      {{"solver.contact_motion"},
       f.solver.structural_motion == StructuralMotion::linear ||
           (m.kind != MotionKind::steady && !m.frictionless),
       "the geometry follows a steady contact alone, and with solver.structural_motion = \"placed\""},
      {{"rail.influence", "wheel.influence"},
       one_file && !f.stresses.asks_for_bodies(),
       "influence files are used where both bodies have one"},
      {{"rail.y", "rail.z"}, f.rail.place == BodyPlace::gauge, "rail.place = \"gauge\" places the rail"},
      {{"wheel.y", "wheel.z"}, f.wheel.place == BodyPlace::gauge, "wheel.place = \"gauge\" places the wheel"},
      {{"position.gauge", "position.gauge_height"},
       f.rail.place == BodyPlace::absolute,
       "rail.place = \"absolute\" places the rail"},
      {{"position.back_to_back", "position.tape_circle"},
       f.wheel.place == BodyPlace::absolute,
       "wheel.place = \"absolute\" places the wheel"},
  };
}

std::vector<Cause> causes_of_grid(const SceneFile& f) {
  const bool patch = f.kind == SceneKind::patch;
  const bool files = !f.rail.influence.empty() && !f.wheel.influence.empty();
  const bool chosen = f.grid.elements || f.grid.accuracy;
  return {
      {{"grid.dx", "grid.ds"}, chosen, "grid.accuracy or grid.elements chooses the elements"},
      {{"grid.accuracy_of"}, !f.grid.accuracy, "grid.accuracy is not given"},
      {{"grid.dx", "gap.a", "gap.c", "stresses.x"},
       f.grid.plane_strain,
       "plane strain is the same all along x"},
      {{"stresses.x", "stresses.s", "stresses.in"},
       f.stresses.depths.empty(),
       "no stresses.depths are given"},
      {{"strip.rail_s0", "strip.wheel_s0"},
       patch && !files && !f.stresses.asks_for_bodies(),
       "they are places in influence files"},
      {{"strip.upper_radius"}, !files && !f.gap.table.empty(), "gap.table is the whole distance"},
  };
}

} // namespace

std::vector<Warning> unused_keys(const SceneFile& f, const Schema& schema) {
  std::vector<Warning> out;
  const auto add = [&](const std::string& keys, const std::string& why) {
    out.push_back({WarningKind::without_effect, fmt::format("{}: without effect ({})", keys, why), keys});
  };
  for (const std::string& text : schema.former_names())
    out.push_back({WarningKind::without_effect, text, text});
  for (const auto& [table, name] : {std::pair{"rail", &f.rail.profile},
                                    {"wheel", &f.wheel.profile},
                                    {"left_rail", &f.wheelset.left_rail.profile},
                                    {"left_wheel", &f.wheelset.left_wheel.profile}}) {
    const std::string& profile = *name;
    if (const auto given = given_reading(schema, table);
        !given.empty() && (is_standard_profile(profile) || profile.ends_with(".toml")))
      add(fmt::format("{}", fmt::join(given, ", ")),
          fmt::format("{} is no profile file{}", profile,
                      profile.ends_with(".toml") ? "; a body file has these keys of its own" : ""));
  }
  for (const std::vector<Cause>& causes : {causes_of_motion(f), causes_of_grid(f), causes_of_bodies(f)})
    for (const Cause& cause : causes) {
      std::vector<const char*> given;
      for (const char* key : cause.keys)
        if (cause.holds && schema.changed(key))
          given.push_back(key);
      if (!given.empty())
        add(fmt::format("{}", fmt::join(given, ", ")), cause.why);
    }
  return out;
}

namespace {

/// What a search finds: the key says at most where it begins.
std::vector<OverruledKey> found_keys(const SceneFile& f) {
  std::vector<OverruledKey> out;
  const auto add = [&](bool given, const char* key, const char* by, const char* what) {
    if (given)
      out.push_back({key, fmt::format("{} is given, and {} is found for it", by, what),
                     fmt::format("Sweep {}, or leave {} out.", by, by)});
  };
  add(f.load.force_y.has_value(), "position.lateral", "load.force_y", "the lateral displacement");
  add(f.wheelset.force_y.has_value(), "position.lateral", "wheelset.force_y", "the lateral displacement");
  add(f.load.force_x.has_value(), "motion.xi", "load.force_x", "the creepage");
  add(f.load.force_s.has_value(), "motion.eta", "load.force_s", "the creepage");
  return out;
}

/// Whether [position] has all that a network would give it.
bool gives_whole_track(const SceneFile& f, const Schema& s) {
  return s.has("position.gauge") && s.has("position.gauge_height") && s.has("position.back_to_back") &&
         s.has("position.rail_inclination") &&
         (s.has("position.tape_circle") || is_standard_profile(f.wheel.profile));
}

} // namespace

std::vector<OverruledKey> overruled_keys(const SceneFile& f, const Schema& schema) {
  std::vector<OverruledKey> out = found_keys(f);
  if (f.track.network && gives_whole_track(f, schema))
    out.push_back(
        {"track.network", "[position] gives all that a network says", "Leave out those keys of [position]."});
  if (f.solver.model)
    for (const char* key : {"solver.model_tolerance", "solver.model_tolerance_of"})
      out.push_back(
          {key, "solver.model is given, and nothing is chosen", "Leave out solver.model, or give \"auto\"."});
  for (const std::vector<Cause>& causes : {causes_of_motion(f), causes_of_grid(f), causes_of_bodies(f)})
    for (const Cause& cause : causes)
      for (const char* key : cause.keys)
        if (cause.holds)
          out.push_back(
              {key, cause.why, "Leave it out of the sweep, or what overrules it out of the scene."});
  return out;
}

} // namespace bem_contact
