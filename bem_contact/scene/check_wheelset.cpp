#include "bem_contact/scene/check_wheelset.hpp"

#include <tuple>

namespace bem_contact {

namespace {

/// A key that a wheelset finds or has twice, and what to do about it.
struct OneWheelKey {
  const char *key, *why, *what_to_do;
};

constexpr const char* shared = "Leave it out: [wheelset] gives the sums of both wheels.";
constexpr const char* slides = "Give motion.speed with motion.lateral_velocity and motion.yaw_rate.";
constexpr OneWheelKey of_one_wheel[] = {
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
};

} // namespace

void check_wheelset(const SceneFile& file, const Schema& schema) {
  if (!file.wheelset.force) {
    for (const char* key :
         {"wheelset.force_y", "wheelset.roll_moment", "wheelset.torque", "wheelset.left_rail_profile",
          "wheelset.left_wheel_profile", "wheelset.left_friction"})
      if (schema.changed(key))
        schema.refuse(key, "wheelset.force is not given", "Give the vertical force on the axle in N.");
    return;
  }
  const SceneFile::Wheelset& w = file.wheelset;
  for (const auto& [influence, profile, key] :
       {std::tuple(&w.left_rail_influence, &w.left_rail, "wheelset.left_rail_influence"),
        {&w.left_wheel_influence, &w.left_wheel, "wheelset.left_wheel_influence"}})
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

} // namespace bem_contact
