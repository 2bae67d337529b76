#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/base/material_keys.hpp"
#include "bem_contact/scene/key_kinds.hpp"
#include "bem_contact/scene/motion_keys.hpp"
#include "bem_contact/scene/position_keys.hpp"

namespace bem_contact {

namespace {

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
         .kinds = wheel_rail_alone,
         .zero_is_none = true});
  s.add("grid.accuracy", g.accuracy,
        {.doc = "Discretisation error that dx and ds are chosen for (0.02: 2 %); 0: dx and ds as given",
         .at_least = 0,
         .at_most = 0.5,
         .kinds = wheel_rail_alone,
         .zero_is_none = true});
  s.add("grid.accuracy_of", g.accuracy_of,
        {.doc = "What that accuracy is about: some of forces, pmax, area, adhesion, approach, creepages, "
                "friction_power, with commas between",
         .kinds = wheel_rail_alone});
  s.add("grid.plane_strain", g.plane_strain,
        {.doc = "One element infinitely long along x (mx = 1), forces per mm", .kinds = patch_alone});
  s.add("grid.s_from", read.s_from,
        {.doc = "First row on the rail's arc length; s_from = s_to = 0: automatic",
         .unit = "mm",
         .kinds = wheel_rail_alone});
  s.add("grid.s_to", read.s_to,
        {.doc = "Last row on the rail's arc length", .unit = "mm", .kinds = wheel_rail_alone});
  s.add("grid.planar", g.planar,
        {.doc = "Planar contact: all rows in the tangent plane at the reference point",
         .kinds = wheel_rail_alone});
}

void add_patch(Schema& s, SceneFile::Gap& gap, SceneFile::Strip& strip) {
  s.add("gap.a", gap.a,
        {.doc = "Undeformed distance h = a x^2 + b s^2 + c x s", .unit = "1/mm", .kinds = patch_alone});
  s.add("gap.b", gap.b, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch_alone});
  s.add("gap.c", gap.c, {.doc = "See gap.a", .unit = "1/mm", .kinds = patch_alone});
  s.add("gap.table", gap.table,
        {.doc = "CSV file with columns ix, is, h instead of a, b, c", .kinds = patch_alone});

  s.add("strip.radius", strip.radius,
        {.doc = "Radius of the lower surface along s, > 0 convex, < 0 concave, 0 flat",
         .unit = "mm",
         .kinds = patch_alone});
  s.add("strip.upper_radius", strip.upper_radius,
        {.doc =
             "Radius of the upper surface along s: with strip.radius the distance of two circles is added to "
             "that of gap.a, b and c (a gap.table is the whole distance); 0: the gap is that of [gap] alone",
         .unit = "mm",
         .kinds = patch_alone});
  s.add("strip.rail_s0", strip.rail_s0,
        {.doc = "Arc length in the lower body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch_alone});
  s.add("strip.wheel_s0", strip.wheel_s0,
        {.doc = "Arc length in the upper body's influence file at the middle of the grid",
         .unit = "mm",
         .kinds = patch_alone});
  s.add("strip.inclination", strip.inclination,
        {.doc = "CSV file with columns is, delta instead of radius", .kinds = patch_alone});
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

void add_wear(Schema& s, SceneFile::Wear& wear) {
  s.add("wear.speeds", wear.speeds,
        {.doc = "bem_contact wear --law archard: borders of sliding speed in the wear map, rising; none: "
                "that of KTH Stockholm",
         .unit = "mm/s",
         .above = 0,
         .kinds = wheel_rail_alone});
  s.add("wear.pressures", wear.pressures,
        {.doc = "Borders of pressure in the wear map, rising",
         .unit = "MPa",
         .above = 0,
         .kinds = wheel_rail_alone});
  s.add("wear.coefficients", wear.coefficients,
        {.doc = "k in each region of the wear map: row by row from the lowest pressure, in each row from the "
                "lowest speed",
         .at_least = 0,
         .kinds = wheel_rail_alone});
}

void add_solver(Schema& s, SceneFile::Solver& solver) {
  s.add("solver.model", solver.model, std::string(automatic_model),
        {.doc =
             "Hertz's closed form (frictionless); influence numbers of the half-space, of half-spaces in the "
             "elements' tangent planes, of the bodies; or the cheapest of these that serves"});
  s.add("solver.model_tolerance", solver.model_tolerance,
        {.doc = "For auto: predicted error of the model that is allowed", .above = 0, .at_most = 1});
  s.add("solver.model_tolerance_of", solver.model_tolerance_of,
        {.doc = "What model_tolerance is about, with commas between: forces, pmax, creepages (those that are "
                "found), friction_power"});
  s.add("solver.tolerance", solver.tolerance,
        {.doc = "Relative tolerance of the iterations", .at_least = 1e-13, .at_most = 1e-7});
  s.add("solver.max_outer", solver.max_outer,
        {.doc = "Most outer iterations between the normal and the tangential problem", .at_least = 1});
  s.add("solver.structural_motion", solver.structural_motion,
        {.doc =
             "Where structural = \"included\" (fem): place the bodies by their structures' motion and solve "
             "again until they stand, or keep the undeformed position's geometry",
         .kinds = wheel_rail_alone});
  s.add("solver.contact_motion", solver.contact_motion,
        {.doc =
             "Surfaces in contact slide past each other as they approach: keep the geometry of the bodies as "
             "they touch, or place the wheel by that motion and solve again until it stands",
         .kinds = wheel_rail_alone});
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
