#include "bem_contact/scene/position_keys.hpp"

#include "bem_contact/base/material_keys.hpp"
#include "bem_contact/scene/key_kinds.hpp"

namespace bem_contact {

void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young) {
  s.add(name + ".profile", side.profile,
        {.doc = role + ": " + standards + ", a profile file or a body file (its contact surface)",
         .kinds = wheel_rail_alone,
         .example = true});
  add_profile_reading(s, name, side.reading, wheel_rail_alone);
  if (name == "wheel")
    add_flange_back(s, name, side.reading, wheel_rail_alone);
  s.add(name + ".place", side.place,
        {.doc = name == "wheel" ? "gauge: by position.back_to_back; absolute: the file's origin is at y, z"
                                : "gauge: by its gauge face; absolute: the file's origin is at y, z",
         .kinds = wheel_rail_alone});
  s.add(name + ".y", side.y,
        {.doc = name == "wheel" ? "With place = \"absolute\": from the wheelset's centre to its side"
                                : "With place = \"absolute\": from the track's centre line to the side",
         .unit = "mm",
         .kinds = wheel_rail_alone});
  s.add(name + ".z", side.z,
        {.doc = "With place = \"absolute\": down", .unit = "mm", .kinds = wheel_rail_alone});
  s.add(name + ".influence", side.influence,
        {.doc = "Influence file (HDF5); empty where only half-space numbers are used"});
  s.add(name + ".structural", side.structural,
        {.doc = "Deflection of the body as a whole (web and foot, or hub)"});
  add_material(s, name + ".material", side.material, young);
}

void add_position(Schema& s, SceneFile::Position& p) {
  s.add("position.side", p.side,
        {.doc = "Which wheel of the wheelset; y, s and what is along them are counted towards its side",
         .kinds = wheel_rail_alone});
  s.add("position.lateral", p.lateral,
        {.doc = "Lateral displacement of the wheelset, positive to the right",
         .unit = "mm",
         .kinds = wheel_rail_alone});
  s.add("position.gauge", p.gauge,
        {.doc = "Track gauge", .unit = "mm", .above = 0, .kinds = wheel_rail_alone});
  s.add("position.gauge_height", p.gauge_height,
        {.doc = "Depth below the top of the rail where the gauge is taken",
         .unit = "mm",
         .above = 0,
         .kinds = wheel_rail_alone});
  s.add("position.back_to_back", p.back_to_back,
        {.doc = "Distance between the flange backs", .unit = "mm", .above = 0, .kinds = wheel_rail_alone});
  s.add("position.cant", p.cant,
        {.doc = "Inclination of the rail towards the track centre (1:40 is 0.025)",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail_alone});
  s.add("position.roll", p.roll,
        {.doc = "Roll of the wheelset, right side down",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail_alone});
  s.add("position.yaw", p.yaw,
        {.doc = "Yaw of the wheelset, its front to the right",
         .unit = "rad",
         .at_least = -0.1,
         .at_most = 0.1,
         .kinds = wheel_rail_alone});
  s.add("position.wheel_radius", p.wheel_radius,
        {.doc = "Nominal wheel radius, at the tape circle",
         .unit = "mm",
         .above = 0,
         .kinds = wheel_rail_alone});
  s.add("position.vertical", p.vertical,
        {.doc = "How far the wheelset's centre stands below wheel_radius above the rail, instead of a load",
         .unit = "mm",
         .kinds = wheel_rail_alone});
  s.add(
      "position.rail_lateral", p.rail_lateral,
      {.doc = "Deviation of the rail from its place, to the right", .unit = "mm", .kinds = wheel_rail_alone});
  s.add("position.rail_vertical", p.rail_vertical,
        {.doc = "Deviation of the rail from its place, down", .unit = "mm", .kinds = wheel_rail_alone});
  s.add("position.rail_roll", p.rail_roll,
        {.doc = "Turn of the rail about the origin of its profile, right side down",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail_alone});
}

void add_load(Schema& s, SceneFile::Load& load) {
  s.add("load.force", load.force,
        {.doc = "Vertical (patch: normal) force, plane strain: per mm; give either this or load.approach",
         .unit = "N",
         .above = 0,
         .example = true});
  s.add("load.approach", load.approach,
        {.doc = "Approach of the bodies; give either this or load.force", .unit = "mm"});

  s.add("load.force_x", load.force_x,
        {.doc = "Longitudinal force on the rail; the creepage that gives it is found and added to motion.xi",
         .unit = "N"});
  s.add("load.force_s", load.force_s,
        {.doc = "Shear force on the rail along its tangent at the reference point, sum p_s cos(delta - "
                "delta_ref) dS; the creepage is found and added to motion.eta",
         .unit = "N"});
  s.add("load.force_y", load.force_y,
        {.doc =
             "Lateral force on the rail, towards the side of this wheel; the lateral displacement that gives "
             "it is found, the one nearest to position.lateral",
         .unit = "N",
         .kinds = wheel_rail_alone});
}

void add_wheelset(Schema& s, SceneFile::Wheelset& w) {
  s.add(
      "wheelset.force", w.force,
      {.doc = "Vertical force on the axle, which both wheels share (bem_contact wheelset), instead of a load",
       .unit = "N",
       .above = 0,
       .kinds = wheel_rail_alone});
  s.add("wheelset.force_y", w.force_y,
        {.doc =
             "Lateral force on the axle, at its centre, to the right; the lateral displacement that gives it "
             "is found from position.lateral on",
         .unit = "N",
         .kinds = wheel_rail_alone});
  s.add("wheelset.roll_moment", w.roll_moment,
        {.doc =
             "Moment on the axle about the forward axis through its centre, right side down. A lateral force "
             "that acts h above the centre adds h times the force",
         .unit = "N mm",
         .kinds = wheel_rail_alone});
  s.add("wheelset.torque", w.torque,
        {.doc = "Torque that drives the axle (braking: below 0), where neither motion.rolling_radius nor "
                "pitch_rate is given; the rolling radius of the axle is found",
         .unit = "N mm",
         .kinds = wheel_rail_alone});
  s.add("wheelset.left_rail_profile", w.left_rail,
        {.doc = "The left rail's profile if it is another one (y to the field side); read as rail.profile is",
         .kinds = wheel_rail_alone});
  s.add("wheelset.left_wheel_profile", w.left_wheel,
        {.doc = "The left wheel's profile if it is another one (y to the field side)",
         .kinds = wheel_rail_alone});
  s.add("wheelset.left_rail_influence", w.left_rail_influence,
        {.doc = "Influence file of wheelset.left_rail_profile", .kinds = wheel_rail_alone});
  s.add("wheelset.left_wheel_influence", w.left_wheel_influence,
        {.doc = "Influence file of wheelset.left_wheel_profile", .kinds = wheel_rail_alone});
  s.add("wheelset.left_friction", w.left_friction,
        {.doc = "Coefficient of friction on the left rail, if it is another one; 0: as motion.friction",
         .at_least = 0,
         .kinds = wheel_rail_alone,
         .zero_is_none = true});
}

} // namespace bem_contact
