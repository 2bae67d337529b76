#include "bem_contact/scene/motion_keys.hpp"

#include "bem_contact/scene/key_kinds.hpp"

#include <string>
#include <utility>

namespace bem_contact {

void add_motion(Schema& s, SceneFile::Motion& m) {
  s.add("motion.kind", m.kind,
        {.doc =
             "Steady rolling; transient rolling from rest, dx a step; or shifts of bodies that do not roll, "
             "xi and eta then in mm a step and phi in rad"});
  s.add("motion.frictionless", m.frictionless, {.doc = "No friction at all: the normal problem alone"});
  s.add("motion.friction", m.friction, {.doc = "Coulomb's coefficient of friction", .at_least = 0});
  s.add("motion.kinetic_friction", m.kinetic_friction,
        {.doc =
             "Coefficient of what slips, at most that of adhesion; 0: the same. With friction_table: of the "
             "largest, and in proportion elsewhere. The result depends on the size of the elements: friction "
             "that falls with the slip velocity (falling_friction) does so less",
         .at_least = 0,
         .zero_is_none = true});
  s.add(
      "motion.falling_friction", m.falling_friction,
      {.doc =
           "Coefficient that friction falls to at high slip velocity w: mu = falling_friction + (friction - "
           "falling_friction) 2^(-w / half_slip_velocity); 0: it does not fall. With friction_table: of the "
           "largest, and in proportion elsewhere. Needs speed",
       .at_least = 0,
       .zero_is_none = true});
  s.add("motion.half_slip_velocity", m.half_slip_velocity,
        {.doc = "Slip velocity at which half of the difference is left (1 m/s is 1000 mm/s)",
         .unit = "mm/s",
         .at_least = 0,
         .zero_is_none = true});
  s.add("motion.polach_a", m.polach_a,
        {.doc = "Instead, Polach's A: friction at high slip velocity over friction; mu = friction [(1 - A) "
                "exp(-B w) + A]; 0: it does not fall. Dry and clean: 0.40, wet: 0.40. Needs speed",
         .at_least = 0,
         .at_most = 1,
         .zero_is_none = true});
  s.add("motion.polach_b", m.polach_b,
        {.doc = "Polach's B. Dry and clean: 0.60, wet: 0.20",
         .unit = "s/m",
         .at_least = 0,
         .zero_is_none = true});
  s.add("motion.friction_table", m.friction_table,
        {.doc = "CSV file with columns s, mu (linear in between) instead of friction; s as in the result. "
                "With two "
                "columns more, falling_friction and half_slip_velocity, each row has its own law"});
  s.add("motion.steps", m.steps,
        {.doc = "Steps of transient rolling or of shifts", .at_least = 1, .at_most = 100000});
  s.add("motion.step_table", m.step_table,
        {.doc =
             "CSV file, one row a step, of columns load, xi, eta, phi, force_x, force_s, x, or some of them: "
             "load is force or approach, whichever is given; force_x and force_s need their keys too; x (mm, "
             "shifts of a patch) is where the contact lies on the grid, which lies still"});
  s.add("motion.start_table", m.start_table,
        {.doc = "CSV file with columns ix, is, px, ps, pn: tractions that transient or shift start from",
         .kinds = patch_alone});
  s.add("motion.xi", m.xi,
        {.doc = "Longitudinal creepage, wheel over rail; wheel_rail: where the bodies touch first"});
  s.add("motion.eta", m.eta, {.doc = "Lateral creepage"});
  s.add("motion.phi", m.phi,
        {.doc = "Spin creepage; in wheel_rail that of the geometry is added", .unit = "1/mm"});
  s.add("motion.rolling_radius", m.rolling_radius,
        {.doc = "Forward over angular speed of the wheel where xi = 0; 0: what rolls freely in the mean",
         .unit = "mm",
         .at_least = 0,
         .kinds = wheel_rail_alone,
         .zero_is_none = true});
  s.add("motion.from_free_rolling", m.from_free_rolling,
        {.doc = "xi is counted from the creepage of free rolling (Fx = 0), which is found first",
         .kinds = wheel_rail_alone});
  s.add("motion.free_rolling", m.free_rolling,
        {.doc = "Find and report the creepage of free rolling too; false saves its solution",
         .kinds = wheel_rail_alone});
  s.add(
      "motion.radial_displacement", m.radial_displacement,
      {.doc =
           "fem, steady rolling: the wheel's surface is faster where it moves away from the axle, by u_r / R "
           "(Kalker's half-space leaves this out)",
       .kinds = wheel_rail_alone});
  s.add(
      "motion.speed", m.speed,
      {.doc =
           "Forward speed of the wheelset (patch: rolling speed), for slip velocities, temperatures and the "
           "rates below",
       .unit = "mm/s",
       .at_least = 0,
       .zero_is_none = true});
  s.add("motion.pitch_rate", m.pitch_rate,
        {.doc = "Angular speed of the wheelset about its axle, positive as it rolls forwards; instead of "
                "rolling_radius",
         .unit = "rad/s",
         .at_least = 0,
         .kinds = wheel_rail_alone,
         .zero_is_none = true});
  s.add("motion.lateral_velocity", m.lateral_velocity,
        {.doc = "Of the wheelset's centre, to the right", .unit = "mm/s", .kinds = wheel_rail_alone});
  s.add("motion.vertical_velocity", m.vertical_velocity,
        {.doc = "Of the wheelset's centre, down", .unit = "mm/s", .kinds = wheel_rail_alone});
  s.add("motion.roll_rate", m.roll_rate,
        {.doc = "Of the wheelset, right side down", .unit = "rad/s", .kinds = wheel_rail_alone});
  s.add("motion.yaw_rate", m.yaw_rate,
        {.doc = "Of the wheelset, front to the right", .unit = "rad/s", .kinds = wheel_rail_alone});
  s.add("motion.slip_table", m.slip_table,
        {.doc = "CSV file with columns ix, is, wx, ws (rigid slip) instead of creepages",
         .kinds = patch_alone});
}

void add_temperature(Schema& s, SceneFile::Temperature& t) {
  s.add(
      "temperature.flash", t.flash,
      {.doc =
           "Temperatures of both surfaces under the heat of friction (steady rolling; needs motion.speed)"});
  for (const auto& [name, body] : {std::pair{"rail", &t.rail}, std::pair{"wheel", &t.wheel}}) {
    const std::string key = std::string("temperature.") + name;
    s.add(key, body->temperature,
          {.doc = std::string("Of the ") + name + " before the contact", .unit = "degC", .above = -273.15});
    s.add(key + "_conductivity", body->conductivity,
          {.doc = "Thermal conductivity", .unit = "W/(m K)", .above = 0});
    s.add(key + "_heat_capacity", body->heat_capacity,
          {.doc = "Specific heat capacity", .unit = "J/(kg K)", .above = 0});
    s.add(key + "_density", body->density, {.doc = "Density", .unit = "kg/m3", .above = 0});
  }
  s.add(
      "temperature.rail_share", t.rail_share,
      {.doc =
           "Share of the heat that flows into the rail; 0: as much as makes both surfaces equally hot where "
           "they touch, which also lets a hot wheel heat a cold rail",
       .at_least = 0,
       .at_most = 1,
       .zero_is_none = true});
  s.add(
      "temperature.hot_friction", t.hot_friction,
      {.doc =
           "Coefficient of friction from falls_to on; linear from falls_from, where motion.friction ends; 0: "
           "friction does not depend on temperature. With friction_table: of the largest, and in proportion "
           "elsewhere",
       .at_least = 0,
       .zero_is_none = true});
  s.add("temperature.falls_from", t.falls_from,
        {.doc = "Mean temperature of the surfaces up to which friction stays", .unit = "degC"});
  s.add("temperature.falls_to", t.falls_to,
        {.doc = "Mean temperature from which it is hot_friction", .unit = "degC"});
}

} // namespace bem_contact
