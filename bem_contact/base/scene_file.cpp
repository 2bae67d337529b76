#include "bem_contact/base/scene_file.hpp"

#include "bem_contact/base/material_keys.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

const std::vector<std::string> wheel_rail{"wheel_rail"}, patch{"patch"};

void add_side(Schema& s, const std::string& name, const std::string& role, SceneFile::Side& side,
              const std::string& standards, double& young) {
  s.add(name + ".profile", side.profile,
        {.doc = role + ": " + standards + ", a profile file or a body file (its contact surface)"});
  s.add(name + ".influence", side.influence,
        {.doc = "Influence file (HDF5); empty where only half-space numbers are used"});
  s.add(name + ".structural", side.structural,
        {.doc = "Deflection of the body as a whole (web and foot, or hub)",
         .choices = {"removed", "included"}});
  add_material(s, name + ".material", side.material, young);
}

void add_position(Schema& s, SceneFile::Position& p) {
  s.add("position.side", p.side,
        {.doc = "Which wheel of the wheelset; y, s and what is along them are counted towards its side",
         .choices = {"right", "left"},
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
         .kinds = wheel_rail,
         .given = &p.has_vertical,
         .alternative = true});
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

/// Young's moduli as read, before they become shear moduli.
struct Youngs {
  double rail = 0, wheel = 0;
};

Schema schema_of(SceneFile& f, Youngs& young) {
  Schema s("scene file");
  s.kind_is("kind");
  s.add("kind", f.kind,
        {.doc = "A wheel on a rail, or one contact problem given directly",
         .choices = {"wheel_rail", "patch"}});
  add_side(s, "rail", "The rail (patch: the lower body)", f.rail, "60E1, 60E2, 54E1, 46E3", young.rail);
  add_side(s, "wheel", "The wheel (patch: the upper body)", f.wheel, "S1002", young.wheel);
  add_position(s, f.position);

  s.add("load.force", f.load.force,
        {.doc = "Vertical (patch: normal) force, plane strain: per mm; give either this or load.approach",
         .unit = "N",
         .above = 0,
         .given = &f.load.has_force});
  s.add("load.approach", f.load.approach,
        {.doc = "Approach of the bodies; give either this or load.force",
         .unit = "mm",
         .given = &f.load.has_approach});

  s.add("load.force_x", f.load.force_x,
        {.doc = "Longitudinal force on the rail; the creepage that gives it is found and added to motion.xi",
         .unit = "N",
         .given = &f.load.has_force_x});
  s.add("load.force_s", f.load.force_s,
        {.doc = "Shear force on the rail along its tangent at the reference point, sum p_s cos(delta - "
                "delta_ref) dS; the creepage is found and added to motion.eta",
         .unit = "N",
         .given = &f.load.has_force_s});

  s.add("motion.kind", f.motion.kind,
        {.doc =
             "Steady rolling; transient rolling from rest, dx a step; or shifts of bodies that do not roll, "
             "xi and eta then in mm a step and phi in rad",
         .choices = {"steady", "transient", "shift"}});
  s.add("motion.frictionless", f.motion.frictionless,
        {.doc = "No friction at all: the normal problem alone"});
  s.add("motion.friction", f.motion.friction, {.doc = "Coulomb's coefficient of friction", .at_least = 0});
  s.add("motion.kinetic_friction", f.motion.kinetic_friction,
        {.doc =
             "Coefficient of what slips, at most that of adhesion; 0: the same. With friction_table: of the "
             "largest, and in proportion elsewhere",
         .at_least = 0});
  s.add("motion.friction_table", f.motion.friction_table,
        {.doc = "CSV file with columns s, mu (linear in between) instead of friction; s as in the result"});
  s.add("motion.steps", f.motion.steps,
        {.doc = "Steps of transient rolling or of shifts", .at_least = 1, .at_most = 100000});
  s.add("motion.step_table", f.motion.step_table,
        {.doc =
             "CSV file, one row a step, of columns load, xi, eta, phi, force_x, force_s, x, or some of them: "
             "load is force or approach, whichever is given; force_x and force_s need their keys too; x (mm, "
             "shifts of a patch) is where the contact lies on the grid, which lies still"});
  s.add("motion.start_table", f.motion.start_table,
        {.doc = "CSV file with columns ix, is, px, ps, pn: tractions that transient or shift start from",
         .kinds = patch});
  s.add("motion.xi", f.motion.xi,
        {.doc = "Longitudinal creepage, wheel over rail; wheel_rail: where the bodies touch first"});
  s.add("motion.eta", f.motion.eta, {.doc = "Lateral creepage"});
  s.add("motion.phi", f.motion.phi,
        {.doc = "Spin creepage; in wheel_rail that of the geometry is added", .unit = "1/mm"});
  s.add("motion.rolling_radius", f.motion.rolling_radius,
        {.doc = "Forward over angular speed of the wheel where xi = 0; 0: what rolls freely in the mean",
         .unit = "mm",
         .at_least = 0,
         .kinds = wheel_rail});
  s.add("motion.speed", f.motion.speed,
        {.doc = "Forward speed of the wheelset, for the velocities and rates below",
         .unit = "mm/s",
         .at_least = 0,
         .kinds = wheel_rail});
  s.add("motion.pitch_rate", f.motion.pitch_rate,
        {.doc = "Angular speed of the wheelset about its axle, positive as it rolls forwards; instead of "
                "rolling_radius",
         .unit = "rad/s",
         .at_least = 0,
         .kinds = wheel_rail});
  s.add("motion.lateral_velocity", f.motion.lateral_velocity,
        {.doc = "Of the wheelset's centre, to the right", .unit = "mm/s", .kinds = wheel_rail});
  s.add("motion.vertical_velocity", f.motion.vertical_velocity,
        {.doc = "Of the wheelset's centre, down", .unit = "mm/s", .kinds = wheel_rail});
  s.add("motion.roll_rate", f.motion.roll_rate,
        {.doc = "Of the wheelset, right side down", .unit = "rad/s", .kinds = wheel_rail});
  s.add("motion.yaw_rate", f.motion.yaw_rate,
        {.doc = "Of the wheelset, front to the right", .unit = "rad/s", .kinds = wheel_rail});
  s.add("motion.slip_table", f.motion.slip_table,
        {.doc = "CSV file with columns ix, is, wx, ws (rigid slip) instead of creepages", .kinds = patch});

  s.add("grid.dx", f.grid.dx,
        {.doc = "Element length along x", .unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  s.add("grid.ds", f.grid.ds,
        {.doc = "Element width along s", .unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  s.add("grid.mx", f.grid.mx,
        {.doc = "Elements along x; 0 (wheel_rail only): from the undeformed distance",
         .at_least = 0,
         .at_most = 4096});
  s.add("grid.ms", f.grid.ms,
        {.doc = "Elements along s; 0 (wheel_rail only): from the undeformed distance",
         .at_least = 0,
         .at_most = 4096});
  s.add("grid.elements", f.grid.elements,
        {.doc = "Elements in contact that dx and ds are chosen for; 0: dx and ds as given",
         .at_least = 0,
         .at_most = 4000,
         .kinds = wheel_rail});
  s.add("grid.accuracy", f.grid.accuracy,
        {.doc = "Discretisation error that dx and ds are chosen for (0.02: 2 %); 0: dx and ds as given",
         .at_least = 0,
         .at_most = 0.5,
         .kinds = wheel_rail});
  s.add("grid.plane_strain", f.grid.plane_strain,
        {.doc = "One element infinitely long along x (mx = 1), forces per mm", .kinds = patch});
  s.add("grid.s_from", f.grid.s_from,
        {.doc = "First row on the rail's arc length; s_from = s_to = 0: automatic",
         .unit = "mm",
         .kinds = wheel_rail});
  s.add("grid.s_to", f.grid.s_to,
        {.doc = "Last row on the rail's arc length", .unit = "mm", .kinds = wheel_rail});
  s.add("grid.planar", f.grid.planar,
        {.doc = "Planar contact: all rows in the tangent plane at the reference point", .kinds = wheel_rail});

  s.add("gap.a", f.gap.a,
        {.doc = "Undeformed distance h = a x^2 + b s^2 + c x s", .unit = "1/mm", .kinds = patch});
  s.add("gap.b", f.gap.b, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch});
  s.add("gap.c", f.gap.c, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch});
  s.add("gap.table", f.gap.table,
        {.doc = "CSV file with columns ix, is, h instead of a, b, c", .kinds = patch});

  s.add("strip.radius", f.strip.radius,
        {.doc = "Radius of the lower surface along s, > 0 convex, < 0 concave, 0 flat",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.upper_radius", f.strip.upper_radius,
        {.doc = "Radius of the upper surface along s, for the gap and its stations; 0 flat",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.rail_s0", f.strip.rail_s0,
        {.doc = "Arc length in the lower body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.wheel_s0", f.strip.wheel_s0,
        {.doc = "Arc length in the upper body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch});
  s.add("strip.inclination", f.strip.inclination,
        {.doc = "CSV file with columns is, delta instead of radius", .kinds = patch});

  s.add("stresses.x", f.stresses.x,
        {.doc = "Stresses below the surface of the rail (patch: lower body), at every x, s and depth",
         .unit = "mm",
         .at_least = -1e6,
         .at_most = 1e6});
  s.add("stresses.s", f.stresses.s,
        {.doc = "Arc length from the reference point (patch: the middle of the grid)",
         .unit = "mm",
         .at_least = -1e6,
         .at_most = 1e6});
  s.add("stresses.depths", f.stresses.depths,
        {.doc = "Depths along the surface's normal; none: stresses are not asked for",
         .unit = "mm",
         .at_least = 1e-6,
         .at_most = 1e6});

  s.add("solver.model", f.solver.model,
        {.doc =
             "Hertz's closed form (frictionless); influence numbers of the half-space, of half-spaces in the "
             "elements' tangent planes, of the bodies; or the cheapest of these that serves",
         .choices = {"auto", "hertz", "halfspace", "tangent_plane", "fem"}});
  s.add(
      "solver.model_tolerance", f.solver.model_tolerance,
      {.doc = "For auto: predicted error of the largest pressure that is allowed", .above = 0, .at_most = 1});
  s.add("solver.tolerance", f.solver.tolerance,
        {.doc = "Relative tolerance of the iterations", .at_least = 1e-13, .at_most = 1e-7});
  s.add("solver.max_outer", f.solver.max_outer,
        {.doc = "Most outer iterations between the normal and the tangential problem", .at_least = 1});
  return s;
}

void check_load(const SceneFile& f, const Schema& s) {
  const int given = f.load.has_force + f.load.has_approach + f.position.has_vertical;
  if (given > 1)
    s.refuse(f.position.has_vertical ? "position.vertical" : "load.approach",
             f.load.has_force ? "load.force is given too" : "load.approach is given too",
             f.position.has_vertical ? "Give exactly one of load.force, load.approach and position.vertical."
                                     : "Give exactly one of load.force and load.approach.");
  if (given == 0)
    s.refuse("load", "neither force nor approach is given", "Give load.force or load.approach.");
}

void check_motion(const SceneFile& f, const Schema& s) {
  if (!f.motion.frictionless && f.motion.friction == 0)
    s.refuse("motion.friction", "zero friction leaves nothing to roll on",
             "Set motion.frictionless = true for the normal problem alone, or give friction > 0.");
  const std::pair<const char*, double> rates[] = {{"motion.pitch_rate", f.motion.pitch_rate},
                                                  {"motion.lateral_velocity", f.motion.lateral_velocity},
                                                  {"motion.vertical_velocity", f.motion.vertical_velocity},
                                                  {"motion.roll_rate", f.motion.roll_rate},
                                                  {"motion.yaw_rate", f.motion.yaw_rate}};
  for (const auto& [key, rate] : rates) {
    if (rate != 0 && f.motion.speed == 0)
      s.refuse(key, "only its ratio to the forward speed counts, and motion.speed is not given",
               "Give motion.speed too.");
    if (rate != 0 && f.motion.kind == "shift")
      s.refuse(key, "a shift has no velocities", "Give xi, eta and phi.");
  }
  if (f.motion.pitch_rate > 0 && f.motion.rolling_radius > 0)
    s.refuse("motion.rolling_radius", "pitch_rate is given too",
             "Give either the rolling radius or both speed and pitch_rate.");
  if (!f.motion.slip_table.empty() && (f.motion.xi != 0 || f.motion.eta != 0 || f.motion.phi != 0))
    s.refuse("motion.slip_table", "creepages are given too", "Give either the table or xi, eta and phi.");
}

void check_steps(const SceneFile& f, const Schema& s) {
  const bool steps = f.motion.steps > 1 || !f.motion.step_table.empty() || !f.motion.start_table.empty();
  if (steps && f.motion.kind == "steady")
    s.refuse("motion.kind", "steady rolling has no steps",
             "Choose transient or shift, or leave out the steps.");
  if (steps && f.motion.frictionless)
    s.refuse("motion.frictionless", "without friction nothing remembers a step",
             "Leave out the steps, or give friction.");
  if (f.motion.steps > 1 && !f.motion.step_table.empty())
    s.refuse("motion.steps", "the step table has a row for each step", "Give either of the two.");
  if ((f.load.has_force_x || f.load.has_force_s) && f.motion.frictionless)
    s.refuse("load", "without friction there is no shear force", "Leave out force_x and force_s.");
  if (f.motion.friction_table.empty() && f.motion.kinetic_friction > f.motion.friction)
    s.refuse("motion.kinetic_friction", fmt::format("friction in adhesion is only {}", f.motion.friction),
             "Give a smaller coefficient.");
}

void check_patch(const SceneFile& f, const Schema& s) {
  if (f.grid.mx < 1)
    s.refuse("grid.mx", "a patch needs its number of elements along x", "Give grid.mx >= 1.");
  if (f.grid.ms < 1)
    s.refuse("grid.ms", "a patch needs its number of elements along s", "Give grid.ms >= 1.");
  if (f.grid.plane_strain && f.grid.mx != 1)
    s.refuse("grid.mx", "plane strain has one element, infinitely long along x", "Give grid.mx = 1.");
  if (!f.gap.table.empty() && (f.gap.a != 0 || f.gap.b != 0 || f.gap.c != 0))
    s.refuse("gap.table", "quadratic coefficients are given too", "Give either the table or a, b and c.");
  if (!f.strip.inclination.empty() && f.strip.radius != 0)
    s.refuse("strip.inclination", "strip.radius is given too", "Give either the table or the radius.");
}

void check_wheel_rail(const SceneFile& f, const Schema& s) {
  if (f.rail.profile.empty())
    s.refuse("rail.profile", "a wheel on a rail needs the rail's profile",
             "Give for instance profile = \"60E1\".");
  if (f.wheel.profile.empty())
    s.refuse("wheel.profile", "a wheel on a rail needs the wheel's profile",
             "Give for instance profile = \"S1002\".");
  if (f.position.back_to_back >= f.position.gauge)
    s.refuse("position.back_to_back", fmt::format("the gauge is only {} mm", f.position.gauge),
             "Give a distance between the flange backs smaller than the gauge.");
  if ((f.grid.elements > 0 || f.grid.accuracy > 0) && (f.grid.mx > 0 || f.grid.ms > 0))
    s.refuse(f.grid.accuracy > 0 ? "grid.accuracy" : "grid.elements", "the numbers mx or ms are given too",
             "Leave out grid.mx and grid.ms.");
  if ((f.grid.elements > 0 || f.grid.accuracy > 0) && f.motion.kind != "steady")
    s.refuse(f.grid.accuracy > 0 ? "grid.accuracy" : "grid.elements",
             "a transient needs one grid for all its steps", "Give grid.dx and grid.ds.");
  if ((f.grid.s_from != 0 || f.grid.s_to != 0) && f.grid.s_to <= f.grid.s_from)
    s.refuse("grid.s_to", fmt::format("the rows would run from {} to {} mm", f.grid.s_from, f.grid.s_to),
             "Give s_to greater than s_from, or leave both out.");
}

} // namespace

SceneFile parse_scene_file(std::string_view toml, std::string_view source_name,
                           std::span<const SceneChange> changes) {
  SceneFile file;
  Youngs young;
  Schema schema = schema_of(file, young);
  schema.skip("sweep");
  schema.read(toml, source_name);
  for (const SceneChange& change : changes)
    schema.set(change.key, change.value, change.line);
  settle_material(schema, "rail.material", file.rail.material, young.rail);
  settle_material(schema, "wheel.material", file.wheel.material, young.wheel);
  check_load(file, schema);
  check_motion(file, schema);
  check_steps(file, schema);
  if (file.kind == "patch")
    check_patch(file, schema);
  else
    check_wheel_rail(file, schema);
  if (file.solver.model == "fem" && file.rail.influence.empty() && file.wheel.influence.empty())
    schema.refuse("solver.model", "no influence file is given",
                  "Give rail.influence and wheel.influence, or use model = \"halfspace\".");
  return file;
}

SceneFile read_scene_file(const std::filesystem::path& path) {
  SceneFile file = parse_scene_file(read_text_file(path.string(), "scene file"), path.string());
  file.folder = path.parent_path();
  return file;
}

std::vector<std::filesystem::path> input_files(const SceneFile& scene) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name :
       {scene.rail.profile, scene.rail.influence, scene.wheel.profile, scene.wheel.influence, scene.gap.table,
        scene.strip.inclination, scene.motion.slip_table, scene.motion.friction_table,
        scene.motion.step_table, scene.motion.start_table})
    if (!name.empty())
      files.push_back(scene.folder / name);
  return files;
}

std::string default_scene_file() {
  SceneFile file;
  file.rail.profile = "60E1";
  file.wheel.profile = "S1002";
  file.load.force = 1e5;
  Youngs young;
  Schema schema = schema_of(file, young);
  file.load.has_force = true; // declared keys start as not given; the printed scene must be complete
  return schema.print();
}

} // namespace bem_contact
