#include "bem_contact/scene/scene_keys.hpp"

#include "bem_contact/base/material_keys.hpp"
#include "bem_contact/scene/derivative_inputs.hpp"
#include "bem_contact/scene/network.hpp"
#include "bem_contact/scene/surface_states.hpp"

#include <fmt/format.h>

namespace bem_contact {

namespace {

void add_grid(Schema& s, SceneFile::Grid& g, SceneKeysAsRead& read) {
  SchemaTable t(s, "grid");
  t.add("dx", g.dx, "Element length along x", {.unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  t.add("ds", g.ds, "Element width along s", {.unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  t.add("mx", g.mx, "Elements along x; 0 (wheel_rail only): from the undeformed distance",
        {.at_least = 0, .at_most = 4096, .zero_is_none = true});
  t.add("ms", g.ms, "Elements along s; 0 (wheel_rail only): from the undeformed distance",
        {.at_least = 0, .at_most = 4096, .zero_is_none = true});
  t.add("elements", g.elements,
        "Elements in contact that dx and ds are chosen for, at most 4000 unless solver.model is halfspace or "
        "hertz; 0: dx and ds as given",
        {.at_least = 0, .at_most = 12000, .kinds = wheel_rail_alone, .zero_is_none = true});
  t.add("accuracy", g.accuracy,
        "Discretisation error that dx and ds are chosen for (0.02: 2 %); 0: dx and ds as given",
        {.at_least = 0, .at_most = 0.5, .kinds = wheel_rail_alone, .zero_is_none = true});
  t.add("accuracy_of", g.accuracy_of,
        "What that accuracy is about: some of forces, pmax, area, adhesion, approach, creepages, "
        "friction_power, with commas between",
        {.kinds = wheel_rail_alone});
  t.add("plane_strain", g.plane_strain, "One element infinitely long along x (mx = 1), forces per mm",
        {.kinds = patch_alone});
  t.add("s_from", read.s_from, "First row on the rail's arc length; s_from = s_to = 0: automatic",
        {.unit = "mm", .kinds = wheel_rail_alone});
  t.add("s_to", read.s_to, "Last row on the rail's arc length", {.unit = "mm", .kinds = wheel_rail_alone});
  t.add("planar", g.planar,
        "Planar contact: the rows of each patch in the plane that touches the rail at its centre of pressure",
        {.kinds = wheel_rail_alone});
}

void add_patch(Schema& s, SceneFile::Gap& gap, SceneFile::Strip& strip) {
  SchemaTable strip_table(s, "strip", patch_alone);
  SchemaTable t(s, "gap", patch_alone);
  t.add("a", gap.a, "Undeformed distance h = a x^2 + b s^2 + c x s", {.unit = "1/mm"});
  t.add("b", gap.b, "See gap.a", {.unit = "1/mm"});
  t.add("c", gap.c, "See gap.a", {.unit = "1/mm"});
  t.add("table", gap.table, "CSV file with columns ix, is, h instead of a, b, c");

  strip_table.add("radius", strip.radius,
                  "Radius of the lower surface along s, > 0 convex, < 0 concave, 0 flat", {.unit = "mm"});
  strip_table.add(
      "upper_radius", strip.upper_radius,
      "Radius of the upper surface along s: with strip.radius the distance of two circles is added to "
      "that of gap.a, b and c (a gap.table is the whole distance); 0: the gap is that of [gap] alone",
      {.unit = "mm"});
  strip_table.add("rail_s0", strip.rail_s0,
                  "Arc length in the lower body's influence file at the middle of the grid", {.unit = "mm"});
  strip_table.add("wheel_s0", strip.wheel_s0,
                  "Arc length in the upper body's influence file at the middle of the grid", {.unit = "mm"});
  strip_table.add("inclination", strip.inclination, "CSV file with columns is, delta instead of radius");
}

void add_layer(Schema& s, SceneFile::Layer& layer) {
  SchemaTable t(s, "layer");
  t.add("state", layer.state,
        "State of the surfaces as others measured it, clean, rig, locomotive, oxide, sand, clay or MoS2: "
        "their layer, and "
        "friction where they say it; each overridden by its own key; empty: none");
  t.add("compliance", layer.compliance,
        "Of a thin layer between the surfaces under shear, of both surfaces together: displacement in mm "
        "under 1 MPa; 0: there is none",
        {.unit = "mm3/N", .at_least = 0, .zero_is_none = true});
  t.add("shear_modulus", layer.shear_modulus,
        "With thickness instead of compliance, which is thickness / shear_modulus; 0: not given",
        {.unit = "MPa", .at_least = 0, .zero_is_none = true});
  t.add("thickness", layer.thickness, "Of the layer, with shear_modulus; 0: not given",
        {.unit = "mm", .at_least = 0, .zero_is_none = true});
  t.add("table", layer.table,
        "CSV file with columns s, compliance (linear in between) instead; s as in the result");
  t.add("slope", layer.slope,
        "Instead, the slope of Fx over xi at xi = 0 with the layer, divided by that without it: its "
        "compliance is found for this contact and reported; 0: not given",
        {.at_least = 0, .at_most = 1, .zero_is_none = true});
  t.add("normal_compliance", layer.normal_compliance,
        "Of the layer under pressure, as of a pressure film: displacement in mm under 1 MPa",
        {.unit = "mm3/N", .at_least = 0});
  t.add("yield_shear", layer.yield_shear,
        "Shear traction at which the layer yields: no traction is larger than this or than friction bears; "
        "with or "
        "without a compliance; 0: it does not yield",
        {.unit = "MPa", .at_least = 0, .zero_is_none = true});
  t.add("yield_temperatures", layer.yield_temperatures,
        "With yield_shears: mean temperatures of both surfaces, rising; needs temperature.flash",
        {.unit = "degC", .above = -273.15});
  t.add("yield_shears", layer.yield_shears,
        "Instead of yield_shear, at each of yield_temperatures: linear in between, constant beyond; none "
        "larger than the one before",
        {.unit = "MPa", .above = 0});
  t.add(
      "hardening", layer.hardening,
      "What yield_shear rises by with the plastic slip of the layer, which rolling carries along; below 0 it "
      "softens",
      {.unit = "MPa/mm", .at_least = -1e12, .at_most = 1e12});
}

void add_stresses(Schema& s, SceneFile::Stresses& stresses) {
  SchemaTable t(s, "stresses");
  t.add("x", stresses.x,
        "Stresses below the surface of the rail (patch: lower body), at every x, s and depth",
        {.unit = "mm", .at_least = -1e6, .at_most = 1e6});
  t.add("s", stresses.s, "Arc length from the reference point (patch: the middle of the grid)",
        {.unit = "mm", .at_least = -1e6, .at_most = 1e6});
  t.add("depths", stresses.depths, "Depths along the surface's normal; none: stresses are not asked for",
        {.unit = "mm", .at_least = 1e-6, .at_most = 1e6});
  t.add(
      "in", stresses.in,
      "Of a half-space, or beside it of the real bodies, whose influence files must have stresses ([stress] "
      "of a body file)");
}

void add_wear(Schema& s, SceneFile::Wear& wear) {
  SchemaTable t(s, "wear", wheel_rail_alone);
  t.add("speeds", wear.speeds,
        "bem_contact wear --law archard: borders of sliding speed in the wear map, rising; none: "
        "that of KTH Stockholm",
        {.unit = "mm/s", .above = 0});
  t.add("pressures", wear.pressures, "Borders of pressure in the wear map, rising",
        {.unit = "MPa", .above = 0});
  t.add("coefficients", wear.coefficients,
        "k in each region of the wear map: row by row from the lowest pressure, in each row from the "
        "lowest speed",
        {.at_least = 0});
}

void add_solver(Schema& s, SceneFile::Solver& solver) {
  SchemaTable t(s, "solver");
  t.add("model", solver.model, std::string(automatic_model),
        "Hertz's closed form (frictionless); influence numbers of the half-space, of half-spaces in the "
        "elements' tangent planes, of the bodies; or the cheapest of these that serves");
  t.add("model_tolerance", solver.model_tolerance, "For auto: predicted error of the model that is allowed",
        {.above = 0, .at_most = 1});
  t.add("model_tolerance_of", solver.model_tolerance_of,
        std::vector<ErrorQuantity>(predicted_quantities.begin(), predicted_quantities.end()),
        "What model_tolerance is about, with commas between: forces, pmax, creepages (those that are "
        "found), friction_power");
  t.add("tolerance", solver.tolerance, "Relative tolerance of the iterations",
        {.at_least = 1e-13, .at_most = 1e-7});
  t.add("max_outer", solver.max_outer, "Most outer iterations between the normal and the tangential problem",
        {.at_least = 1});
  t.add("structural_motion", solver.structural_motion,
        "Where structural = \"included\" (fem): place the bodies by their structures' motion and solve "
        "again until they stand, or keep the undeformed position's geometry",
        {.kinds = wheel_rail_alone});
  t.add("contact_motion", solver.contact_motion,
        "Surfaces in contact slide past each other as they approach: keep the geometry of the bodies as "
        "they touch, or place the wheel by that motion and solve again until it stands",
        {.kinds = wheel_rail_alone});
}

/// What the table leaves out is as on the right. `right` is settled.
void settle_left(const Schema& s, const std::string& name, const SceneFile::Side& right,
                 SceneFile::Wheelset::LeftSide& left) {
  const auto given = [&](const char* key) { return s.has(fmt::format("{}.{}", name, key)); };
  if (left.profile.empty() && given_reading(s, name).empty())
    return;
  ProfileReading reading = right.reading;
  if (given("smoothing"))
    reading.smoothing = left.reading.smoothing;
  if (given("nominal"))
    reading.nominal = left.reading.nominal;
  if (given("unit"))
    reading.unit = left.reading.unit;
  if (given("profile_z"))
    reading.profile_z = left.reading.profile_z;
  if (given("mirror"))
    reading.mirror = left.reading.mirror;
  if (given("flange_back"))
    reading.flange_back = left.reading.flange_back;
  left.reading = reading;
  if (!left.profile.empty())
    return;
  left.profile = right.profile;
  if (left.influence.empty())
    left.influence = right.influence;
}

} // namespace

Schema scene_schema(SceneFile& f, SceneKeysAsRead& read) {
  Schema s("scene file");
  s.kind_is("kind");
  s.add("kind", f.kind, "A wheel on a rail, or one contact problem given directly");
  s.add("derivatives", f.derivatives, derivative_names(), "none",
        "Numbers of the scene with respect to which the result has derivatives, a list: all, load, lateral, "
        "roll, yaw, xi, eta, phi, friction and others");
  add_side(s, "rail", "The rail", f.rail, "a standard of bem_contact profile --list", read.rail_young);
  add_side(s, "wheel", "The wheel", f.wheel, "a standard, as S1002", read.wheel_young);
  add_rail_joint(s, f.rail.joint);
  add_wheel_unevenness(s, f.wheel);
  add_position(s, f.position);
  add_track(s, f.track);
  add_load(s, f.load);
  add_wheelset(s, f.wheelset);
  add_left_sides(s, f.wheelset);
  add_motion(s, f.motion);
  add_grid(s, f.grid, read);
  add_patch(s, f.gap, f.strip);
  add_layer(s, f.layer);
  add_stresses(s, f.stresses);
  add_temperature(s, f.temperature);
  add_wear(s, f.wear);
  add_solver(s, f.solver);
  return s;
}

void settle(SceneFile& f, const Schema& s, const SceneKeysAsRead& read) {
  settle_material(s, "rail.material", f.rail.material, read.rail_young);
  settle_material(s, "wheel.material", f.wheel.material, read.wheel_young);
  apply_state(f, s);
  set_network(f, s);
  f.wheel.reading.tape_circle = f.position.tape_circle;
  for (SceneFile::Side* side : {&f.rail, &f.wheel}) {
    if (!side->sections.empty())
      side->profile = side->sections.front().profile;
    if (side->has_sections()) // which all have the same origin
      side->reading.keep_origin = true;
  }
  for (SceneFile::Side* side : {&f.rail, &f.wheel})
    if (side->place == BodyPlace::absolute) {
      side->reading.keep_origin = true;
      (side == &f.rail ? f.position.rail_origin : f.position.wheel_origin) = Point2{side->y, side->z};
    }
  settle_left(s, "left_rail", f.rail, f.wheelset.left_rail);
  settle_left(s, "left_wheel", f.wheel, f.wheelset.left_wheel);
  f.position.roller_radius = f.rail.roller_radius.value_or(0);
  f.position.uneven.flat = f.wheel.flat;
  f.position.uneven.polygon = f.wheel.polygon;
  f.position.uneven.joint = f.rail.joint;
  f.position.uneven.sections_angle = f.wheel.sections_angle;
  if (read.s_from != 0 || read.s_to != 0)
    f.grid.rows = {read.s_from, read.s_to};
}

} // namespace bem_contact
