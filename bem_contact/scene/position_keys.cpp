#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/base/material_keys.hpp"

#include <fmt/format.h>

namespace bem_contact {

void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young) {
  SchemaTable t(s, name);
  t.add("profile", side.profile,
        role + ": " + standards + ", a profile file or a body file (its contact surface)",
        {.kinds = wheel_rail_alone, .example = true});
  add_profile_reading(s, name, side.reading, wheel_rail_alone);
  if (name == "wheel")
    add_flange_back(s, name, side.reading, wheel_rail_alone);
  t.add("place", side.place,
        name == "wheel" ? "gauge: by position.back_to_back; absolute: the file's origin is at y, z"
                        : "gauge: by its gauge face; absolute: the file's origin is at y, z",
        {.kinds = wheel_rail_alone});
  t.add("y", side.y,
        name == "wheel" ? "With place = \"absolute\": from the wheelset's centre to its side"
                        : "With place = \"absolute\": from the track's centre line to the side",
        {.unit = "mm", .kinds = wheel_rail_alone});
  t.add("z", side.z, "With place = \"absolute\": down", {.unit = "mm", .kinds = wheel_rail_alone});
  if (name == "rail")
    t.add("roller_radius", side.roller_radius,
          "Of a roller rig: the rail is a surface of revolution whose axis, parallel to y, lies so far below "
          "z = 0, "
          "the top of the rail; 0: a straight rail",
          {.unit = "mm", .at_least = 0, .kinds = wheel_rail_alone, .zero_is_none = true});
  add_sections(s, side, name);
  if (name == "rail")
    add_bodies(s, side);
  t.add("influence", side.influence, "Influence file (HDF5); empty where only half-space numbers are used");
  t.add("structural", side.structural, "Deflection of the body as a whole (web and foot, or hub)");
  add_material(s, name + ".material", side.material, young);
  SchemaTable material(s, name + ".material");
  material.add("limit_pressure", side.limit_pressure,
               "Pressure that the surface bears at the most: it is indented for good where the pressure "
               "would be larger. "
               "The lower one of both bodies acts; 0: none, or that of steel",
               {.unit = "MPa", .at_least = 0, .zero_is_none = true});
  material.add("steel", side.steel,
               "Steel whose hardness is limit_pressure, as R260, R350HT (EN 13674) or ER7, ER8 (EN 13262); "
               "empty: none");
}

void add_position(Schema& s, SceneFile::Position& p) {
  SchemaTable t(s, "position", wheel_rail_alone);
  t.add("side", p.side,
        "Which wheel of the wheelset; y, s and what is along them are counted towards its side");
  t.add("lateral", p.lateral, "Lateral displacement of the wheelset, positive to the right", {.unit = "mm"});
  t.add(
      "along", p.uneven.along,
      "Place of the wheelset along the track, for a wheel or rail that is uneven: the wheel has rolled there "
      "from 0",
      {.unit = "mm", .at_least = -farthest_along, .at_most = farthest_along});
  t.add("gauge", p.gauge, "Track gauge", {.unit = "mm", .above = 0});
  t.add("gauge_height", p.gauge_height, "Depth below the top of the rail where the gauge is taken",
        {.unit = "mm", .above = 0});
  t.add("back_to_back", p.back_to_back, "Distance between the flange backs", {.unit = "mm", .above = 0});
  add_tape_circle(s, "position", p.tape_circle, wheel_rail_alone);
  t.add("rail_inclination", p.rail_inclination,
        "Inclination of the rail towards the track centre (1:40 is 0.025)",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5, .formerly = "position.cant"});
  t.add("roll", p.roll, "Roll of the wheelset, right side down",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5});
  t.add("yaw", p.yaw, "Yaw of the wheelset against the track, its front to the right",
        {.unit = "rad", .at_least = -0.1, .at_most = 0.1});
  t.add("wheel_radius", p.wheel_radius, "Nominal wheel radius, at the tape circle",
        {.unit = "mm", .above = 0});
  t.add("vertical", p.vertical,
        "Instead of a load: how far the wheelset's centre is lower than wheel_radius above the rail",
        {.unit = "mm"});
  t.add("rail_lateral", p.rail_lateral, "Deviation of the rail from its place, to the right", {.unit = "mm"});
  t.add("rail_vertical", p.rail_vertical, "Deviation of the rail from its place, down", {.unit = "mm"});
  t.add("rail_roll", p.rail_roll, "Turn of the rail about the origin of its profile, right side down",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5});
  t.add("wheel_lateral", p.deviation.lateral,
        "Of a wheel in a flexible wheelset, from where the rigid wheelset has it: to the right",
        {.unit = "mm"});
  t.add("wheel_vertical", p.deviation.vertical, "The same, down", {.unit = "mm"});
  t.add("wheel_roll", p.deviation.roll, "The same: turn about its own centre, right side down",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5});
  t.add("wheel_yaw", p.deviation.yaw, "The same, front to the right",
        {.unit = "rad", .at_least = -0.1, .at_most = 0.1});
}

void add_track(Schema& s, SceneFile::Track& track) {
  SchemaTable t(s, "track", wheel_rail_alone);
  t.add("network", track.network, "none",
        "Whose gauge, gauge_height, back_to_back, tape_circle and rail_inclination [position] has where it "
        "does not give them; none: those of its defaults");
  t.add(
      "curve_radius", track.curve_radius,
      "Radius of the curve, above 0: its centre is to the right; the wheelset then yaws at motion.speed over "
      "it. 0: straight track",
      {.unit = "mm", .zero_is_none = true});
  t.add("superelevation", track.superelevation,
        "Height of the outer rail above the inner one over track.base. In a wheelset force is normal to the "
        "track, and force (v^2 / (g curve_radius) - superelevation / base), outwards, is added to force_y",
        {.unit = "mm"});
  t.add("base", track.base, "Distance of the rolling circles of both wheels", {.unit = "mm", .above = 0});
}

void add_load(Schema& s, SceneFile::Load& load) {
  SchemaTable t(s, "load");
  t.add("force", load.force,
        "Vertical (patch: normal) force, plane strain: per mm; give either this or load.approach",
        {.unit = "N", .above = 0, .example = true});
  t.add("approach", load.approach, "Approach of the bodies; give either this or load.force", {.unit = "mm"});

  t.add("force_x", load.force_x,
        "Longitudinal force on the rail; the creepage that gives it is found and added to motion.xi",
        {.unit = "N"});
  t.add("force_s", load.force_s,
        "Shear force on the rail along its tangent at the reference point, sum p_s cos(delta - "
        "delta_ref) dS; the creepage is found and added to motion.eta",
        {.unit = "N"});
  t.add("force_y", load.force_y,
        "Lateral force on the rail, towards the side of this wheel; the lateral displacement that gives "
        "it is found, the one nearest to position.lateral",
        {.unit = "N", .kinds = wheel_rail_alone});
}

namespace {

/// What of a left body may differ from the right one.
void add_left_side(Schema& s, const std::string& name, const std::string& right,
                   SceneFile::Wheelset::LeftSide& left) {
  SchemaTable t(s, name, wheel_rail_alone);
  t.add("profile", left.profile,
        fmt::format("Of a wheelset: the profile on the left (y to the field side) if it is another one; what "
                    "this table "
                    "leaves out is as in [{}]",
                    right),
        {.formerly = fmt::format("wheelset.{}_profile", name)});
  add_profile_reading(s, name, left.reading, wheel_rail_alone);
  if (right == "wheel")
    add_flange_back(s, name, left.reading, wheel_rail_alone);
  t.add("influence", left.influence, fmt::format("Influence file (HDF5) of {}.profile", name),
        {.formerly = fmt::format("wheelset.{}_influence", name)});
}

} // namespace

void add_left_sides(Schema& s, SceneFile::Wheelset& w) {
  add_left_side(s, "left_rail", "rail", w.left_rail);
  s.add("left_rail.inclination", w.left_rail_inclination,
        "Of the left rail towards the track centre, if it is another one; not given: as "
        "position.rail_inclination",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5, .kinds = wheel_rail_alone});
  add_left_side(s, "left_wheel", "wheel", w.left_wheel);
}

void add_wheelset(Schema& s, SceneFile::Wheelset& w) {
  SchemaTable t(s, "wheelset", wheel_rail_alone);
  t.add("force", w.force,
        "Vertical force on the axle, which both wheels share (bem_contact wheelset), instead of a load",
        {.unit = "N", .above = 0});
  t.add("force_y", w.force_y,
        "Lateral force on the axle, at its centre, to the right (besides that of a curve); the lateral "
        "displacement that gives it is found from position.lateral on",
        {.unit = "N"});
  t.add("roll_moment", w.roll_moment,
        "Moment on the axle about the forward axis through its centre, right side down. A lateral force "
        "that acts h above the centre adds h times the force",
        {.unit = "N mm"});
  t.add("torque", w.torque,
        "Torque that drives the axle (braking: below 0), where neither motion.rolling_radius nor "
        "pitch_rate is given; the rolling radius of the axle is found",
        {.unit = "N mm"});
  t.add("left_wheel_radius", w.left_wheel_radius,
        "Nominal radius of the left wheel if it is another one; 0: as position.wheel_radius",
        {.unit = "mm", .at_least = 0, .zero_is_none = true});
  t.add("left_friction", w.left_friction,
        "Coefficient of friction on the left rail, if it is another one; 0: as motion.friction",
        {.at_least = 0, .zero_is_none = true});
}

} // namespace bem_contact
