#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/scene/friction_laws.hpp"

#include <string>
#include <utility>

namespace bem_contact {

namespace {

void add_friction(SchemaTable& t, SceneFile::Motion& m) {
  t.add("friction", m.friction, "Coulomb's coefficient of friction", {.at_least = 0});
  t.add("kinetic_friction", m.kinetic_friction,
        "Coefficient of what slips, at most that of adhesion; 0: the same. With friction_table: of the "
        "largest, and in proportion elsewhere. The result depends on the size of the elements: friction "
        "that falls with the slip velocity (falling_friction) does so less",
        {.at_least = 0, .zero_is_none = true});
  for (const AskedLaw& law : friction_laws())
    for (const AskedLaw::Number& number : law.numbers)
      t.add(number.name(), m.*number.member, number.help, number.rule);
  t.add("friction_memory", m.friction_memory,
        "Distance of slip (some micrometres) over which friction that falls follows a slip velocity that "
        "changes; 0: at once. "
        "In steady rolling",
        {.unit = "mm", .at_least = 0, .zero_is_none = true});
  t.add("memory_velocity", m.memory_velocity, "With it: what sticks forgets as fast as at this slip velocity",
        {.unit = "mm/s", .above = 0});
  t.add("friction_table", m.friction_table,
        "CSV file with columns s, mu (linear in between) instead of friction; s as in the result, or in its "
        "place "
        "inclination: delta of the result, rad. With two columns more, falling_friction and "
        "half_slip_velocity, each row has its own law");
}

/// How the wheelset moves, and its wheel besides, if it is flexible.
void add_velocities(SchemaTable& t, SceneFile::Motion& m) {
  t.add("speed", m.speed,
        "Forward speed of the wheelset (patch: rolling speed), for slip velocities, temperatures and the "
        "rates below",
        {.unit = "mm/s", .at_least = 0, .zero_is_none = true});
  t.add("pitch_rate", m.pitch_rate,
        "Angular speed of the wheelset about its axle, positive as it rolls forwards; instead of "
        "rolling_radius",
        {.unit = "rad/s", .at_least = 0, .kinds = wheel_rail_alone, .zero_is_none = true});
  t.add("lateral_velocity", m.lateral_velocity, "Of the wheelset's centre, to the right",
        {.unit = "mm/s", .kinds = wheel_rail_alone});
  t.add("vertical_velocity", m.vertical_velocity, "Of the wheelset's centre, down",
        {.unit = "mm/s", .kinds = wheel_rail_alone});
  t.add("roll_rate", m.roll_rate, "Of the wheelset, right side down",
        {.unit = "rad/s", .kinds = wheel_rail_alone});
  t.add("yaw_rate", m.yaw_rate,
        "Of the wheelset, front to the right; in a curve besides speed / track.curve_radius",
        {.unit = "rad/s", .kinds = wheel_rail_alone});
  t.add("wheel_forward_velocity", m.wheel.forward,
        "Of a wheel in a flexible wheelset, besides that of the wheelset: forwards",
        {.unit = "mm/s", .kinds = wheel_rail_alone});
  t.add("wheel_lateral_velocity", m.wheel.lateral, "The same, to the right: rate of position.wheel_lateral",
        {.unit = "mm/s", .kinds = wheel_rail_alone});
  t.add("wheel_vertical_velocity", m.wheel.vertical, "The same, down",
        {.unit = "mm/s", .kinds = wheel_rail_alone});
  t.add("wheel_roll_rate", m.wheel.roll, "The same: rate of position.wheel_roll",
        {.unit = "rad/s", .kinds = wheel_rail_alone});
  t.add("wheel_pitch_rate", m.wheel.pitch, "The same: about the axle, positive as it rolls forwards",
        {.unit = "rad/s", .kinds = wheel_rail_alone});
  t.add("wheel_yaw_rate", m.wheel.yaw, "The same: rate of position.wheel_yaw",
        {.unit = "rad/s", .kinds = wheel_rail_alone});
}

} // namespace

void add_motion(Schema& s, SceneFile::Motion& m) {
  SchemaTable t(s, "motion");
  t.add("kind", m.kind,
        "Steady rolling; transient rolling from rest, dx a step; or shifts of bodies that do not roll, "
        "xi and eta then in mm a step and phi in rad");
  t.add("frictionless", m.frictionless, "No friction at all: the normal problem alone");
  add_friction(t, m);
  t.add("steps", m.steps, "Steps of transient rolling or of shifts", {.at_least = 1, .at_most = 100000});
  t.add(
      "first_shift", m.first_shift,
      "Transient: in the first step the bodies slide over each other as far as in so many rolling steps, as "
      "they do where a shift comes before rolling",
      {.above = 0});
  t.add("step_table", m.step_table,
        "CSV file, one row a step, of columns load, xi, eta, phi, force_x, force_s, x, or some of them: "
        "load is force or approach, whichever is given; force_x and force_s need their keys too; x (mm, "
        "shifts of a patch) is where the contact lies on the grid, which lies still");
  t.add("start_table", m.start_table,
        "CSV file with columns ix, is, px, ps, pn: tractions that transient or shift start from; with a "
        "further "
        "column plastic_slip (mm) that of a layer that yields",
        {.kinds = patch_alone});
  t.add("xi", m.xi, "Longitudinal creepage, wheel over rail; wheel_rail: at the middle of the contact");
  t.add("eta", m.eta, "Lateral creepage");
  t.add("phi", m.phi, "Spin creepage; in wheel_rail that of the geometry is added", {.unit = "1/mm"});
  t.add("rolling_radius", m.rolling_radius,
        "Forward over angular speed of the wheel where xi = 0; 0: what rolls freely in the mean",
        {.unit = "mm", .at_least = 0, .kinds = wheel_rail_alone, .zero_is_none = true});
  t.add("from_free_rolling", m.from_free_rolling,
        "xi is counted from the creepage of free rolling (Fx = 0), which is found first",
        {.kinds = wheel_rail_alone});
  t.add("free_rolling", m.free_rolling,
        "Find and report the creepage of free rolling too; false saves its solution",
        {.kinds = wheel_rail_alone});
  t.add("radial_displacement", m.radial_displacement,
        "fem, steady rolling: the wheel's surface is faster where it moves away from the axle, by u_r / R "
        "(Kalker's half-space leaves this out)",
        {.kinds = wheel_rail_alone});
  add_velocities(t, m);
  t.add("roller_speed", m.roller_speed,
        "Angular speed of the roller (rail.roller_radius); creepage is relative to the mean speed of both "
        "surfaces. "
        "0: the roller's surface has the forward speed at the middle of the contact",
        {.unit = "rad/s", .at_least = 0, .kinds = wheel_rail_alone, .zero_is_none = true});
  t.add("slip_table", m.slip_table, "CSV file with columns ix, is, wx, ws (rigid slip) instead of creepages",
        {.kinds = patch_alone});
}

void add_temperature(Schema& s, SceneFile::Temperature& given) {
  SchemaTable t(s, "temperature");
  t.add("flash", given.flash,
        "Temperatures of both surfaces under the heat of friction (steady rolling; needs motion.speed)");
  for (const auto& [name, body] : {std::pair{"rail", &given.rail}, std::pair{"wheel", &given.wheel}}) {
    const std::string key = name;
    t.add(key, body->temperature, "Of the " + key + " before the contact",
          {.unit = "degC", .above = -273.15});
    t.add(key + "_conductivity", body->conductivity, "Thermal conductivity", {.unit = "W/(m K)", .above = 0});
    t.add(key + "_heat_capacity", body->heat_capacity, "Specific heat capacity",
          {.unit = "J/(kg K)", .above = 0});
    t.add(key + "_density", body->density, "Density", {.unit = "kg/m3", .above = 0});
  }
  t.add("rail_share", given.rail_share,
        "Share of the heat that flows into the rail; 0: as much as makes both surfaces equally hot where "
        "they touch, which also lets a hot wheel heat a cold rail",
        {.at_least = 0, .at_most = 1, .zero_is_none = true});
  t.add("hot_friction", given.hot_friction,
        "Coefficient of friction from falls_to on; linear from falls_from, where motion.friction ends; 0: "
        "friction does not depend on temperature. With friction_table: of the largest, and in proportion "
        "elsewhere",
        {.at_least = 0, .zero_is_none = true});
  t.add("falls_from", given.falls_from, "Mean temperature of the surfaces up to which friction stays",
        {.unit = "degC"});
  t.add("falls_to", given.falls_to, "Mean temperature from which it is hot_friction", {.unit = "degC"});
}

} // namespace bem_contact
