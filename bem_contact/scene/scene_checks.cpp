#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/scene/friction_laws.hpp"
#include "bem_contact/scene/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace bem_contact {

namespace {

/// A key that a wheelset finds or has twice, and what to do about it.
struct OneWheelKey {
  const char *key, *why, *what_to_do;
};

constexpr const char* shared = "Leave it out: [wheelset] gives the sums of both wheels.";
constexpr const char* slides = "Give motion.speed with motion.lateral_velocity and motion.yaw_rate.";
constexpr const char *deviates = "it is the deviation of one wheel",
                     *rigid = "Leave it out: the wheelset is rigid.";
constexpr OneWheelKey of_one_wheel[] = {
    {"position.wheel_lateral", deviates, rigid},
    {"position.wheel_vertical", deviates, rigid},
    {"position.wheel_roll", deviates, rigid},
    {"position.wheel_yaw", deviates, rigid},
    {"motion.wheel_forward_velocity", deviates, rigid},
    {"motion.wheel_lateral_velocity", deviates, rigid},
    {"motion.wheel_vertical_velocity", deviates, rigid},
    {"motion.wheel_roll_rate", deviates, rigid},
    {"motion.wheel_pitch_rate", deviates, rigid},
    {"motion.wheel_yaw_rate", deviates, rigid},
    {"load.force", "it is the force on one wheel, and both share wheelset.force", shared},
    {"load.approach", "both wheels approach their rails by what wheelset.force asks for", shared},
    {"load.force_x", "it is the force on one wheel", "Give wheelset.torque."},
    {"load.force_s", "it is the force on one wheel", "Give wheelset.force_y."},
    {"load.force_y", "it is the force on one wheel", "Give wheelset.force_y."},
    {"position.vertical", "the height of the wheelset is found", shared},
    {"position.roll", "the roll of the wheelset is found", "Give wheelset.roll_moment, or leave it out."},
    {"motion.xi", "both wheels turn with one axle", "Give wheelset.torque or motion.rolling_radius."},
    {"motion.eta", "it is the creepage of one wheel", slides},
    {"motion.phi", "it is the creepage of one wheel", slides},
    {"motion.from_free_rolling", "one wheel of an axle does not roll freely", "Give wheelset.torque."},
    {"derivatives", "they hold where the wheelset stands, and it would stand elsewhere",
     "Leave it out, or ask for those of one wheel at the pose that was found (load.force)."},
};

/// A scene with a table [wheelset] has neither a load nor a position of one wheel.
void check_wheelset(const SceneFile& file, const Schema& schema) {
  if (!file.wheelset.force) {
    std::vector<std::string> keys{
        "wheelset.force_y",      "wheelset.roll_moment",      "wheelset.torque",     "wheelset.left_friction",
        "left_rail.profile",     "left_wheel.profile",        "left_rail.influence", "left_wheel.influence",
        "left_rail.inclination", "wheelset.left_wheel_radius"};
    for (const char* table : {"left_rail", "left_wheel"})
      std::ranges::move(given_reading(schema, table), std::back_inserter(keys));
    for (const std::string& key : keys)
      if (schema.changed(key))
        schema.refuse(key, "wheelset.force is not given", "Give the vertical force on the axle in N.");
    return;
  }
  const SceneFile::Wheelset& w = file.wheelset;
  for (const auto& [influence, profile, key] :
       {std::tuple(&w.left_rail.influence, &w.left_rail.profile, "left_rail.influence"),
        {&w.left_wheel.influence, &w.left_wheel.profile, "left_wheel.influence"}})
    if (!influence->empty() && profile->empty())
      schema.refuse(key, "its profile is not given", "Give the left side's profile too.");
  if (w.left_friction && !file.motion.friction_table.empty())
    schema.refuse("wheelset.left_friction", "motion.friction_table is given", "Give either of the two.");
  for (const OneWheelKey& k : of_one_wheel)
    if (schema.changed(k.key))
      schema.refuse(k.key, k.why, k.what_to_do);
  if (file.position.side == WheelSide::left)
    schema.refuse("position.side", "both wheels are solved", "Leave it out.");
  if (file.motion.kind != MotionKind::steady)
    schema.refuse("motion.kind", "a wheelset's forces are balanced in steady rolling",
                  "Choose motion.kind = \"steady\".");
  if (schema.changed("wheelset.torque") && (file.motion.rolling_radius || file.motion.pitch_rate))
    schema.refuse("wheelset.torque", "the rolling radius is given (motion.rolling_radius or pitch_rate)",
                  "Give either of the two.");
  if (schema.changed("wheelset.torque") && file.motion.frictionless)
    schema.refuse("wheelset.torque", "without friction the rails bear no torque", "Leave it out.");
}

constexpr const char* too_small = "the bodies would approach by no more than their coordinates are rounded";

void check_load(const SceneFile& f, const Schema& s) {
  const int given = f.load.force.has_value() + f.load.approach.has_value() + f.position.vertical.has_value();
  if (given > 1)
    s.refuse(f.position.vertical ? "position.vertical" : "load.approach",
             f.load.force ? "load.force is given too" : "load.approach is given too",
             f.position.vertical ? "Give exactly one of load.force, load.approach and position.vertical."
                                 : "Give exactly one of load.force and load.approach.");
  if (given == 0)
    s.refuse("load", "neither force nor approach is given",
             s.has("sweep") || s.has("passage")
                 ? "Give load.force or load.approach; a scene whose table [sweep] does is for "
                   "bem_contact sweep."
             : s.has("table") ? "Give load.force or load.approach; a scene whose table [table] does is for "
                                "bem_contact table."
                              : "Give load.force or load.approach.");
  if (f.kind == SceneKind::wheel_rail && f.load.force.value_or(least_force) < least_force)
    s.refuse("load.force", too_small, fmt::format("Give {} N or more.", least_force));
  if (f.kind == SceneKind::wheel_rail && f.load.approach.value_or(0) > 0 && *f.load.approach < least_approach)
    s.refuse("load.approach", too_small, fmt::format("Give {} mm or more.", least_approach));
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
                                                  {"motion.yaw_rate", f.motion.yaw_rate},
                                                  {"motion.roller_speed", f.motion.roller_speed.value_or(0)},
                                                  {"motion.wheel_forward_velocity", f.motion.wheel.forward},
                                                  {"motion.wheel_lateral_velocity", f.motion.wheel.lateral},
                                                  {"motion.wheel_vertical_velocity", f.motion.wheel.vertical},
                                                  {"motion.wheel_roll_rate", f.motion.wheel.roll},
                                                  {"motion.wheel_pitch_rate", f.motion.wheel.pitch},
                                                  {"motion.wheel_yaw_rate", f.motion.wheel.yaw}};
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

void check_roller(const SceneFile& f, const Schema& s) {
  if (!f.rail.roller_radius) {
    if (f.motion.roller_speed)
      s.refuse("motion.roller_speed", "the rail is straight, and rail.roller_radius is not given",
               "Give the radius of the roller, or leave it out.");
    return;
  }
  if (f.track.curve_radius)
    s.refuse("track.curve_radius", "rail.roller_radius is given, and a roller rig has no curve",
             "Give the wheelset's yaw, and motion.roller_speed.");
}

void check_track(const SceneFile& f, const Schema& s) {
  const SceneFile::Track& track = f.track;
  if (!track.curve_radius && track.superelevation != 0)
    s.refuse("track.superelevation", "straight track has no outer rail, and track.curve_radius is not given",
             "Give the radius of the curve, or leave it out.");
  if (std::abs(track.superelevation) >= track.base)
    s.refuse("track.superelevation", fmt::format("the rails are {} mm apart", track.base),
             "Give the height of the outer rail above the inner one, in mm.");
  if (!track.curve_radius)
    return;
  if (std::abs(*track.curve_radius) <= track.base)
    s.refuse(
        "track.curve_radius",
        fmt::format("the centre of the curve would lie between the rails, which are {} mm apart", track.base),
        "Give the radius in mm.");
  if (!f.motion.speed)
    s.refuse("track.curve_radius", "how a curve is run through depends on motion.speed, which is not given",
             "Give motion.speed in mm/s.");
  if (f.motion.kind == MotionKind::shift)
    s.refuse("track.curve_radius", "a shift does not roll through a curve", "Leave it out.");
}

void check_steps(const SceneFile& f, const Schema& s) {
  const bool steps = f.motion.steps > 1 || !f.motion.step_table.empty() || !f.motion.start_table.empty();
  if (steps && f.motion.kind == MotionKind::steady)
    s.refuse("motion.kind", "steady rolling has no steps",
             "Choose transient or shift, or leave out the steps.");
  if (f.motion.first_shift != 1 && f.motion.kind != MotionKind::transient)
    s.refuse("motion.first_shift", "only transient rolling has a first step from rest",
             "Choose motion.kind = \"transient\", or leave it out.");
  if (f.motion.first_shift != 1 && !f.motion.start_table.empty())
    s.refuse("motion.first_shift", "motion.start_table gives tractions that have rolled already",
             "Leave out one of the two.");
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
  if (f.rail.profile.empty() && f.rail.sections.empty())
    s.refuse("rail.profile", "a wheel on a rail needs the rail's profile",
             "Give for instance profile = \"60E1\".");
  if (f.wheel.profile.empty() && f.wheel.sections.empty())
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

void check_falling(const SceneFile::Motion& m, const Schema& s) {
  const AskedLaw* asked = asked_law(m);
  if (!asked)
    return;
  const char* key = asked->numbers[0].key;
  for (const AskedLaw& other : friction_laws())
    if (&other != asked && m.*other.numbers[0].member)
      s.refuse(other.numbers[0].key, fmt::format("{} is given too", key), "Give one law of friction.");
  if (!(m.*asked->numbers[1].member))
    s.refuse(key, asked->why_both, asked->give_both);
  if (m.kinetic_friction)
    s.refuse("motion.kinetic_friction", "friction falls with the slip velocity too",
             "Give one law of friction.");
  if (m.kind == MotionKind::shift)
    s.refuse(key, "a shift has no slip velocity", "Choose rolling, or give motion.kinetic_friction.");
  if (!m.speed)
    s.refuse(key, "the slip velocity is the slip times motion.speed, which is not given",
             "Give motion.speed in mm/s.");
  if (m.friction_table.empty() && asked->law(m, m.friction).ratio > 1)
    s.refuse(key, fmt::format("friction in adhesion is only {}", m.friction), "Give a smaller coefficient.");
}

void check_temperature(const SceneFile& f, const Schema& s) {
  const SceneFile::Temperature& t = f.temperature;
  if (!t.flash && t.hot_friction)
    s.refuse("temperature.hot_friction", "temperatures are not asked for", "Set temperature.flash = true.");
  if (!t.flash || f.motion.frictionless)
    return;
  if (f.motion.kind != MotionKind::steady)
    s.refuse("temperature.flash", "the temperatures are those of steady rolling",
             "Choose motion.kind = \"steady\", or leave it out.");
  if (!f.motion.speed)
    s.refuse("temperature.flash", "heat is proportional to the speed, and motion.speed is not given",
             "Give motion.speed in mm/s.");
  if (!t.hot_friction)
    return;
  if (t.falls_to <= t.falls_from)
    s.refuse("temperature.falls_to",
             fmt::format("friction begins to fall at {} degrees C (temperature.falls_from)", t.falls_from),
             "Give a higher temperature.");
  if (f.motion.kinetic_friction)
    s.refuse("temperature.hot_friction", "motion.kinetic_friction is given too", "Give one law of friction.");
  if (f.motion.friction_table.empty() && *t.hot_friction > f.motion.friction)
    s.refuse("temperature.hot_friction", fmt::format("friction is only {}", f.motion.friction),
             "Give a smaller coefficient.");
}

void check_stresses(const SceneFile& f, const Schema& s) {
  const SceneFile::Stresses& asked = f.stresses;
  for (const auto& [key, places] : {std::pair{"stresses.x", &asked.x}, {"stresses.s", &asked.s}})
    if (!asked.depths.empty() && places->empty())
      s.refuse(key, "stresses.depths are given, and no point lies below an empty list",
               "Give places, for instance [0.0], or leave out stresses.depths.");
  if (!asked.asks_for_bodies())
    return;
  if (f.rail.influence.empty() && f.wheel.influence.empty())
    s.refuse("stresses.in", "stresses in the bodies come from influence files, and none is given",
             "Give rail.influence, wheel.influence or both, or use in = \"halfspace\".");
  if (f.grid.plane_strain)
    s.refuse("stresses.in", "in plane strain elements are endless along x, and nothing passes a body",
             "Use in = \"halfspace\".");
}

void check_memory(const SceneFile& f, const Schema& s) {
  if (!f.motion.friction_memory || f.motion.frictionless)
    return;
  if (!asked_law(f.motion) && f.motion.friction_table.empty())
    s.refuse("motion.friction_memory", "friction does not fall with the slip velocity",
             "Give motion.falling_friction or polach_a, or leave it out.");
  if (f.motion.kind != MotionKind::steady)
    s.refuse("motion.friction_memory", "it is that of steady rolling", "Choose motion.kind = \"steady\".");
  if (f.layer.yields())
    s.refuse("motion.friction_memory", "the layer yields (layer.yield_shear, yield_shears)",
             "Give one of the two.");
}

/// Friction that depends on slip, slip velocity or temperature, and [temperature].
void check_friction(const SceneFile& file, const Schema& schema) {
  if (!file.motion.frictionless)
    check_falling(file.motion, schema);
  check_temperature(file, schema);
}

} // namespace

void check_keys(const SceneFile& f, const Schema& s) {
  check_wheelset(f, s);
  if (!f.wheelset.force)
    check_load(f, s);
  check_motion(f, s);
  check_roller(f, s);
  check_track(f, s);
  check_steps(f, s);
  check_friction(f, s);
  check_layer(f, s);
  check_memory(f, s);
  check_stresses(f, s);
  if (f.kind == SceneKind::patch)
    check_patch(f, s);
  else {
    check_wheel_rail(f, s);
    check_unevenness(f, s);
  }
  if (f.solver.model && words_of(*f.solver.model).needs_files && !f.rail.has_influence() &&
      f.wheel.influence.empty())
    s.refuse("solver.model", "no influence file is given",
             "Give rail.influence and wheel.influence (bem_contact influence list names prepared files, "
             "tools/influence NAME computes others), or use model = \"halfspace\".");
}

} // namespace bem_contact
