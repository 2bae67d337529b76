#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/base/material_keys.hpp"

namespace bem_contact {

namespace {

const std::vector<std::string> wheel_rail{std::string(name_of(SceneKind::wheel_rail))};
const std::vector<std::string> patch{std::string(name_of(SceneKind::patch))};

void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young) {
  s.add(name + ".profile", side.profile,
        {.doc = role + ": " + standards + ", a profile file or a body file (its contact surface)",
         .kinds = wheel_rail,
         .example = true});
  add_profile_reading(s, name, side.reading, wheel_rail);
  if (name == "wheel")
    add_flange_back(s, name, side.reading, wheel_rail);
  s.add(name + ".place", side.place,
        {.doc = name == "wheel" ? "gauge: by position.back_to_back; absolute: the file's origin is at y, z"
                                : "gauge: by its gauge face; absolute: the file's origin is at y, z",
         .kinds = wheel_rail});
  s.add(name + ".y", side.y,
        {.doc = name == "wheel" ? "With place = \"absolute\": from the wheelset's centre to its side"
                                : "With place = \"absolute\": from the track's centre line to the side",
         .unit = "mm",
         .kinds = wheel_rail});
  s.add(name + ".z", side.z, {.doc = "With place = \"absolute\": down", .unit = "mm", .kinds = wheel_rail});
  s.add(name + ".influence", side.influence,
        {.doc = "Influence file (HDF5); empty where only half-space numbers are used"});
  s.add(name + ".structural", side.structural,
        {.doc = "Deflection of the body as a whole (web and foot, or hub)"});
  add_material(s, name + ".material", side.material, young);
}

void add_position(Schema& s, SceneFile::Position& p) {
  s.add("position.side", p.side,
        {.doc = "Which wheel of the wheelset; y, s and what is along them are counted towards its side",
         .kinds = wheel_rail});
  s.add("position.lateral", p.lateral,
        {.doc = "Lateral displacement of the wheelset, positive to the right",
         .unit = "mm",
         .kinds = wheel_rail});
  s.add("position.gauge", p.gauge, {.doc = "Track gauge", .unit = "mm", .above = 0, .kinds = wheel_rail});
  s.add("position.gauge_height", p.gauge_height,
        {.doc = "Depth below the top of the rail where the gauge is taken",
         .unit = "mm",
         .above = 0,
         .kinds = wheel_rail});
  s.add("position.back_to_back", p.back_to_back,
        {.doc = "Distance between the flange backs", .unit = "mm", .above = 0, .kinds = wheel_rail});
  s.add("position.cant", p.cant,
        {.doc = "Inclination of the rail towards the track centre (1:40 is 0.025)",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail});
  s.add("position.roll", p.roll,
        {.doc = "Roll of the wheelset, right side down",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail});
  s.add("position.yaw", p.yaw,
        {.doc = "Yaw of the wheelset, its front to the right",
         .unit = "rad",
         .at_least = -0.1,
         .at_most = 0.1,
         .kinds = wheel_rail});
  s.add("position.wheel_radius", p.wheel_radius,
        {.doc = "Nominal wheel radius, at the tape circle", .unit = "mm", .above = 0, .kinds = wheel_rail});
  s.add("position.vertical", p.vertical,
        {.doc = "How far the wheelset's centre stands below wheel_radius above the rail, instead of a load",
         .unit = "mm",
         .kinds = wheel_rail});
  s.add("position.rail_lateral", p.rail_lateral,
        {.doc = "Deviation of the rail from its place, to the right", .unit = "mm", .kinds = wheel_rail});
  s.add("position.rail_vertical", p.rail_vertical,
        {.doc = "Deviation of the rail from its place, down", .unit = "mm", .kinds = wheel_rail});
  s.add("position.rail_roll", p.rail_roll,
        {.doc = "Turn of the rail about the origin of its profile, right side down",
         .unit = "rad",
         .at_least = -0.5,
         .at_most = 0.5,
         .kinds = wheel_rail});
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
         .kinds = wheel_rail});
}

void add_wheelset(Schema& s, SceneFile::Wheelset& w) {
  s.add(
      "wheelset.force", w.force,
      {.doc = "Vertical force on the axle, which both wheels share (bem_contact wheelset), instead of a load",
       .unit = "N",
       .above = 0,
       .kinds = wheel_rail});
  s.add("wheelset.force_y", w.force_y,
        {.doc =
             "Lateral force on the axle, at its centre, to the right; the lateral displacement that gives it "
             "is found from position.lateral on",
         .unit = "N",
         .kinds = wheel_rail});
  s.add("wheelset.roll_moment", w.roll_moment,
        {.doc =
             "Moment on the axle about the forward axis through its centre, right side down. A lateral force "
             "that acts h above the centre adds h times the force",
         .unit = "N mm",
         .kinds = wheel_rail});
  s.add("wheelset.torque", w.torque,
        {.doc = "Torque that drives the axle (braking: below 0), where neither motion.rolling_radius nor "
                "pitch_rate is given; the rolling radius of the axle is found",
         .unit = "N mm",
         .kinds = wheel_rail});
  s.add("wheelset.left_rail_profile", w.left_rail,
        {.doc = "The left rail's profile if it is another one (y to the field side); read as rail.profile is",
         .kinds = wheel_rail});
  s.add("wheelset.left_wheel_profile", w.left_wheel,
        {.doc = "The left wheel's profile if it is another one (y to the field side)", .kinds = wheel_rail});
  s.add("wheelset.left_rail_influence", w.left_rail_influence,
        {.doc = "Influence file of wheelset.left_rail_profile", .kinds = wheel_rail});
  s.add("wheelset.left_wheel_influence", w.left_wheel_influence,
        {.doc = "Influence file of wheelset.left_wheel_profile", .kinds = wheel_rail});
  s.add("wheelset.left_friction", w.left_friction,
        {.doc = "Coefficient of friction on the left rail, if it is another one; 0: as motion.friction",
         .at_least = 0,
         .kinds = wheel_rail,
         .zero_is_none = true});
}

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
         .kinds = patch});
  s.add("motion.xi", m.xi,
        {.doc = "Longitudinal creepage, wheel over rail; wheel_rail: where the bodies touch first"});
  s.add("motion.eta", m.eta, {.doc = "Lateral creepage"});
  s.add("motion.phi", m.phi,
        {.doc = "Spin creepage; in wheel_rail that of the geometry is added", .unit = "1/mm"});
  s.add("motion.rolling_radius", m.rolling_radius,
        {.doc = "Forward over angular speed of the wheel where xi = 0; 0: what rolls freely in the mean",
         .unit = "mm",
         .at_least = 0,
         .kinds = wheel_rail,
         .zero_is_none = true});
  s.add("motion.from_free_rolling", m.from_free_rolling,
        {.doc = "xi is counted from the creepage of free rolling (Fx = 0), which is found first",
         .kinds = wheel_rail});
  s.add("motion.free_rolling", m.free_rolling,
        {.doc = "Find and report the creepage of free rolling too; false saves its solution",
         .kinds = wheel_rail});
  s.add(
      "motion.radial_displacement", m.radial_displacement,
      {.doc =
           "fem, steady rolling: the wheel's surface is faster where it moves away from the axle, by u_r / R "
           "(Kalker's half-space leaves this out)",
       .kinds = wheel_rail});
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
         .kinds = wheel_rail,
         .zero_is_none = true});
  s.add("motion.lateral_velocity", m.lateral_velocity,
        {.doc = "Of the wheelset's centre, to the right", .unit = "mm/s", .kinds = wheel_rail});
  s.add("motion.vertical_velocity", m.vertical_velocity,
        {.doc = "Of the wheelset's centre, down", .unit = "mm/s", .kinds = wheel_rail});
  s.add("motion.roll_rate", m.roll_rate,
        {.doc = "Of the wheelset, right side down", .unit = "rad/s", .kinds = wheel_rail});
  s.add("motion.yaw_rate", m.yaw_rate,
        {.doc = "Of the wheelset, front to the right", .unit = "rad/s", .kinds = wheel_rail});
  s.add("motion.slip_table", m.slip_table,
        {.doc = "CSV file with columns ix, is, wx, ws (rigid slip) instead of creepages", .kinds = patch});
}

void add_grid(Schema& s, SceneFile::Grid& g, SceneKeysAsRead& read) {
  s.add("grid.dx", g.dx, {.doc = "Element length along x", .unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  s.add("grid.ds", g.ds, {.doc = "Element width along s", .unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  s.add("grid.mx", g.mx,
        {.doc = "Elements along x; 0 (wheel_rail only): from the undeformed distance",
         .at_least = 0,
         .at_most = 4096,
         .zero_is_none = true});
  s.add("grid.ms", g.ms,
        {.doc = "Elements along s; 0 (wheel_rail only): from the undeformed distance",
         .at_least = 0,
         .at_most = 4096,
         .zero_is_none = true});
  s.add("grid.elements", g.elements,
        {.doc = "Elements in contact that dx and ds are chosen for; 0: dx and ds as given",
         .at_least = 0,
         .at_most = 4000,
         .kinds = wheel_rail,
         .zero_is_none = true});
  s.add("grid.accuracy", g.accuracy,
        {.doc = "Discretisation error that dx and ds are chosen for (0.02: 2 %); 0: dx and ds as given",
         .at_least = 0,
         .at_most = 0.5,
         .kinds = wheel_rail,
         .zero_is_none = true});
  s.add("grid.accuracy_of", g.accuracy_of,
        {.doc = "What that accuracy is about: some of forces, pmax, area, adhesion, approach, creepages, "
                "friction_power, with commas between",
         .kinds = wheel_rail});
  s.add("grid.plane_strain", g.plane_strain,
        {.doc = "One element infinitely long along x (mx = 1), forces per mm", .kinds = patch});
  s.add("grid.s_from", read.s_from,
        {.doc = "First row on the rail's arc length; s_from = s_to = 0: automatic",
         .unit = "mm",
         .kinds = wheel_rail});
  s.add("grid.s_to", read.s_to,
        {.doc = "Last row on the rail's arc length", .unit = "mm", .kinds = wheel_rail});
  s.add("grid.planar", g.planar,
        {.doc = "Planar contact: all rows in the tangent plane at the reference point", .kinds = wheel_rail});
}

void add_patch(Schema& s, SceneFile::Gap& gap, SceneFile::Strip& strip) {
  s.add("gap.a", gap.a,
        {.doc = "Undeformed distance h = a x^2 + b s^2 + c x s", .unit = "1/mm", .kinds = patch});
  s.add("gap.b", gap.b, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch});
  s.add("gap.c", gap.c, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch});
  s.add("gap.table", gap.table,
        {.doc = "CSV file with columns ix, is, h instead of a, b, c", .kinds = patch});

  s.add("strip.radius", strip.radius,
        {.doc = "Radius of the lower surface along s, > 0 convex, < 0 concave, 0 flat",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.upper_radius", strip.upper_radius,
        {.doc =
             "Radius of the upper surface along s: with strip.radius the distance of two circles is added to "
             "that of gap.a, b and c (a gap.table is the whole distance); 0: the gap is that of [gap] alone",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.rail_s0", strip.rail_s0,
        {.doc = "Arc length in the lower body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.wheel_s0", strip.wheel_s0,
        {.doc = "Arc length in the upper body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.inclination", strip.inclination,
        {.doc = "CSV file with columns is, delta instead of radius", .kinds = patch});
}

void add_stresses(Schema& s, SceneFile::Stresses& stresses) {
  s.add("stresses.x", stresses.x,
        {.doc = "Stresses below the surface of the rail (patch: lower body), at every x, s and depth",
         .unit = "mm",
         .at_least = -1e6,
         .at_most = 1e6});
  s.add("stresses.s", stresses.s,
        {.doc = "Arc length from the reference point (patch: the middle of the grid)",
         .unit = "mm",
         .at_least = -1e6,
         .at_most = 1e6});
  s.add("stresses.depths", stresses.depths,
        {.doc = "Depths along the surface's normal; none: stresses are not asked for",
         .unit = "mm",
         .at_least = 1e-6,
         .at_most = 1e6});
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

void add_wear(Schema& s, SceneFile::Wear& wear) {
  s.add("wear.speeds", wear.speeds,
        {.doc = "bem_contact wear --law archard: borders of sliding speed in the wear map, rising; none: "
                "that of KTH Stockholm",
         .unit = "mm/s",
         .above = 0,
         .kinds = wheel_rail});
  s.add(
      "wear.pressures", wear.pressures,
      {.doc = "Borders of pressure in the wear map, rising", .unit = "MPa", .above = 0, .kinds = wheel_rail});
  s.add("wear.coefficients", wear.coefficients,
        {.doc = "k in each region of the wear map: row by row from the lowest pressure, in each row from the "
                "lowest speed",
         .at_least = 0,
         .kinds = wheel_rail});
}

void add_solver(Schema& s, SceneFile::Solver& solver) {
  s.add("solver.model", solver.model, std::string(automatic_model),
        {.doc =
             "Hertz's closed form (frictionless); influence numbers of the half-space, of half-spaces in the "
             "elements' tangent planes, of the bodies; or the cheapest of these that serves"});
  s.add(
      "solver.model_tolerance", solver.model_tolerance,
      {.doc = "For auto: predicted error of the largest pressure that is allowed", .above = 0, .at_most = 1});
  s.add("solver.tolerance", solver.tolerance,
        {.doc = "Relative tolerance of the iterations", .at_least = 1e-13, .at_most = 1e-7});
  s.add("solver.max_outer", solver.max_outer,
        {.doc = "Most outer iterations between the normal and the tangential problem", .at_least = 1});
  s.add("solver.structural_motion", solver.structural_motion,
        {.doc =
             "Where structural = \"included\" (fem): place the bodies by their structures' motion and solve "
             "again until they stand, or keep the undeformed position's geometry",
         .kinds = wheel_rail});
  s.add("solver.contact_motion", solver.contact_motion,
        {.doc =
             "Surfaces in contact slide past each other as they approach: keep the geometry of the bodies as "
             "they touch, or place the wheel by that motion and solve again until it stands",
         .kinds = wheel_rail});
}

} // namespace

Schema scene_schema(SceneFile& f, SceneKeysAsRead& read) {
  Schema s("scene file");
  s.kind_is("kind");
  s.add("kind", f.kind, {.doc = "A wheel on a rail, or one contact problem given directly"});
  add_side(s, "rail", "The rail", f.rail, "60E1, 60E2, 54E1, 46E3", read.rail_young);
  add_side(s, "wheel", "The wheel", f.wheel, "S1002", read.wheel_young);
  add_position(s, f.position);
  add_load(s, f.load);
  add_wheelset(s, f.wheelset);
  add_motion(s, f.motion);
  add_grid(s, f.grid, read);
  add_patch(s, f.gap, f.strip);
  add_stresses(s, f.stresses);
  add_temperature(s, f.temperature);
  add_wear(s, f.wear);
  add_solver(s, f.solver);
  return s;
}

void settle(SceneFile& f, const Schema& s, const SceneKeysAsRead& read) {
  settle_material(s, "rail.material", f.rail.material, read.rail_young);
  settle_material(s, "wheel.material", f.wheel.material, read.wheel_young);
  for (SceneFile::Side* side : {&f.rail, &f.wheel})
    if (side->place == BodyPlace::absolute) {
      side->reading.keep_origin = true;
      (side == &f.rail ? f.position.rail_origin : f.position.wheel_origin) = Point2{side->y, side->z};
    }
  if (read.s_from != 0 || read.s_to != 0)
    f.grid.rows = {read.s_from, read.s_to};
}

} // namespace bem_contact
