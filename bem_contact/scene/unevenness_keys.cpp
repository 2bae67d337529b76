#include "bem_contact/scene/scene_keys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <set>
#include <utility>

namespace bem_contact {

void add_wheel_unevenness(Schema& s, SceneFile::Side& wheel) {
  SchemaTable flat(s, "wheel.flat", wheel_rail_alone);
  flat.add("length", wheel.flat.length,
           "Of a flat of the wheel, along its running surface; 0: that of a chord of this depth, or no flat",
           {.unit = "mm", .at_least = 0});
  flat.add("depth", wheel.flat.depth, "In the middle of the flat; 0: that of a chord of this length",
           {.unit = "mm", .at_least = 0});
  flat.add("rounding", wheel.flat.rounding,
           "Length over which each edge of the flat is rounded; 0: new, sharp",
           {.unit = "mm", .at_least = 0});
  flat.add("angle", wheel.flat.angle,
           "Where the middle of the flat is when position.along is 0: 0 below the axle, growing forwards",
           {.unit = "rad", .at_least = -1e3, .at_most = 1e3});
  SchemaTable polygon(s, "wheel.polygon", wheel_rail_alone);
  polygon.add("orders", wheel.polygon.orders,
              "Waves on the circumference of a wheel that is out of round; none: it is round",
              {.at_least = 1, .at_most = 1000});
  polygon.add("amplitudes", wheel.polygon.amplitudes,
              "One for each order: the radius grows by amplitude cos(order (angle - phase))",
              {.unit = "mm", .at_least = -10, .at_most = 10});
  polygon.add(
      "phases", wheel.polygon.phases,
      "One for each order: where a crest is when position.along is 0, as wheel.flat.angle; none: all 0",
      {.unit = "rad", .at_least = -1e3, .at_most = 1e3});
}

void add_rail_joint(Schema& s, RailJoint& joint) {
  SchemaTable t(s, "rail.joint", wheel_rail_alone);
  t.add("at", joint.at, "Where the middle of a joint lies along the track, as position.along",
        {.unit = "mm", .at_least = -farthest_along, .at_most = farthest_along});
  t.add("gap", joint.gap, "Between the ends of the rails", {.unit = "mm", .at_least = 0, .at_most = 100});
  t.add("step", joint.step, "By how much the second rail lies lower at the joint; below 0: higher",
        {.unit = "mm", .at_least = -20, .at_most = 20});
  t.add("dip", joint.dip, "How far both ends dip below the rails, two halves of a parabola",
        {.unit = "mm", .at_least = 0, .at_most = 50});
  t.add("dip_length", joint.dip_length, "Over which the rails dip, half of it on either side",
        {.unit = "mm", .above = 0});
  t.add("rounding", joint.rounding, "Radius of the edges of the rails' ends where there is a gap or a step",
        {.unit = "mm", .at_least = 0, .at_most = 50});
}

namespace {

/// 1. Steepest slope of a dip: the rail is looked at straightened, and pressures are off by the square of the
/// slope, 0.1 %.
constexpr double steepest_dip = 0.03;
/// 1. Steepest slope of a wheel out of round: ten times that of a corrugated tyre that is worn out.
constexpr double steepest_wave = 0.1;
/// 1. Share by which a depth that is measured may exceed that of the chord.
constexpr double chord_tolerance = 0.02;

void check_flat(const SceneFile& f, const Schema& s) {
  const WheelFlat& flat = f.wheel.flat;
  if (!flat.given()) {
    for (const char* key : {"wheel.flat.rounding", "wheel.flat.angle"})
      if (s.changed(key))
        s.refuse(key, "the flat has neither length nor depth", "Give wheel.flat.length or depth in mm.");
    return;
  }
  const double radius = f.position.wheel_radius;
  if (flat.length >= radius)
    s.refuse("wheel.flat.length", fmt::format("the wheel's radius is {:g} mm", radius),
             "Give the length of the flat in mm.");
  if (flat.depth >= 0.1 * radius)
    s.refuse("wheel.flat.depth", fmt::format("the wheel's radius is {:g} mm", radius),
             "Give the depth of the flat in mm; 1 mm is much.");
  if (flat.length > 0 && flat.depth > (1 + chord_tolerance) * depth_of_chord(radius, flat.length))
    s.refuse("wheel.flat.depth",
             fmt::format("a chord of {:g} mm is {:.4g} mm deep on this wheel, and a rail grinds no hollow",
                         flat.length, depth_of_chord(radius, flat.length)),
             "Give a smaller depth, a longer flat, or one of the two.");
  const double length = flat.length > 0 ? flat.length : 2 * std::sqrt(flat.depth * (2 * radius - flat.depth));
  if (flat.rounding > 0.5 * length)
    s.refuse("wheel.flat.rounding", fmt::format("the flat is {:.4g} mm long", length),
             "Give at most half of that for each of its edges.");
}

void check_polygon(const SceneFile& f, const Schema& s) {
  const WheelPolygon& polygon = f.wheel.polygon;
  const std::size_t orders = polygon.orders.size();
  if (polygon.amplitudes.size() != orders)
    s.refuse("wheel.polygon.amplitudes",
             fmt::format("there are {} of them and {} orders", polygon.amplitudes.size(), orders),
             "Give one amplitude for each order.");
  if (!polygon.phases.empty() && polygon.phases.size() != orders)
    s.refuse("wheel.polygon.phases",
             fmt::format("there are {} of them and {} orders", polygon.phases.size(), orders),
             "Give one phase for each order, or none.");
  if (const auto broken = std::ranges::find_if(polygon.orders, [](double n) { return n != std::round(n); });
      broken != polygon.orders.end())
    s.refuse("wheel.polygon.orders", fmt::format("{:g} waves do not close round a wheel", *broken),
             "Give whole numbers.");
  double slope = 0;
  for (std::size_t i = 0; i < orders; ++i)
    slope += std::abs(polygon.amplitudes[i]) * polygon.orders[i] / f.position.wheel_radius;
  if (slope > steepest_wave)
    s.refuse("wheel.polygon.amplitudes",
             fmt::format("the running surface would slope by up to {:.3g}", slope),
             "Give the amplitudes in mm; 0.1 mm is much.");
}

void check_joint(const SceneFile& f, const Schema& s) {
  const RailJoint& joint = f.rail.joint;
  if (!joint.given()) {
    for (const char* key : {"rail.joint.at", "rail.joint.dip_length", "rail.joint.rounding"})
      if (s.changed(key))
        s.refuse(key, "the joint has neither gap, step nor dip", "Give one of them in mm.");
    return;
  }
  if (joint.gap >= f.position.wheel_radius)
    s.refuse("rail.joint.gap", fmt::format("the wheel's radius is {:g} mm", f.position.wheel_radius),
             "Give a gap that the wheel passes.");
  if (const double slope = 4 * joint.dip / joint.dip_length; slope > steepest_dip)
    s.refuse("rail.joint.dip", fmt::format("its rails would slope by {:.3g} at the joint", slope),
             fmt::format("Give a longer rail.joint.dip_length: slopes up to {:g} are solved.", steepest_dip));
}

std::size_t number_of_bodies(const SceneFile::Side& rail) {
  std::set<std::string> names;
  for (const SceneFile::Section& section : rail.sections)
    names.insert(section.body);
  return names.size();
}

/// What both kinds of bodies of sections share.
void check_list_of_sections(const SceneFile::Side& side, const std::string& name, const Schema& s) {
  if (!side.sections.empty() && s.changed(name + ".profile"))
    s.refuse(name + ".profile", fmt::format("{}.sections is given too", name), "Give either of the two.");
  for (std::size_t i = 0; i < side.sections.size(); ++i) {
    const SceneFile::Section& section = side.sections[i];
    const std::size_t lines = section.features.size() + section.without.size();
    for (const double number : section.without)
      if (number != std::round(number) || number < 1 || number > static_cast<double>(lines))
        s.refuse(name + ".sections",
                 fmt::format("section {} is without feature {:g}, and it speaks of {} features", i + 1,
                             number, lines),
                 "Number the features from 1, in the order along the profile.");
  }
}

/// The key that gives a body's sections; null: it has one profile.
const char* key_of_sections(const SceneFile::Side& side, bool rail) {
  return !side.sections.empty()       ? (rail ? "rail.sections" : "wheel.sections")
         : names_slices(side.profile) ? (rail ? "rail.profile" : "wheel.profile")
                                      : nullptr;
}

/// N/mm. What a rail lies on at the least: under 100 kN it would sink by a metre. A bound.
constexpr double softest_bed = 100;

void check_bodies(const SceneFile& f, const Schema& s) {
  std::size_t on_springs = 0;
  for (std::size_t i = 0; i < f.rail.bodies.size(); ++i) {
    const SceneFile::Body& body = f.rail.bodies[i];
    if (std::ranges::count(f.rail.sections, body.name, &SceneFile::Section::body) == 0)
      s.refuse("rail.bodies", fmt::format("no section has the body '{}'", body.name),
               "Give the names that rail.sections have.");
    if (std::ranges::count(f.rail.bodies, body.name, &SceneFile::Body::name) > 1)
      s.refuse("rail.bodies", fmt::format("'{}' is there twice", body.name), "Leave one of them out.");
    if (const double k = body.stiffness.value_or(0); k > 0 && k < softest_bed)
      s.refuse(
          "rail.bodies",
          fmt::format("'{}' lies on {:g} N/mm, and a wheel would press it down by a metre", body.name, k),
          fmt::format("Give N/mm, at least {:g}; rails lie on some 1e4.", softest_bed));
    on_springs += body.stiffness ? 1 : 0;
  }
  if (on_springs == 0)
    return;
  if (number_of_bodies(f.rail) != 2)
    s.refuse("rail.bodies",
             fmt::format("a stiffness is given, and there are {} bodies", number_of_bodies(f.rail)),
             "Two share a load by their stiffness; give none to let others share it as rigid bodies.");
  if (!f.load.force || f.load.force_y)
    s.refuse("rail.bodies", "bodies on springs share a load, and load.force alone is not given",
             "Give load.force and position.lateral.");
}

/// Influence files of sections of a rail: of each body two or more, or that of its one section.
void check_influence(const SceneFile& f, const Schema& s) {
  if (!f.rail.influence.empty())
    s.refuse("rail.influence", "it is that of a rail that is the same all along the track",
             "Give it with the section that it belongs to: { at = ..., profile = ..., influence = ... }.");
  if (!f.rail.has_influence())
    return;
  if (f.rail.structural == StructuralCompliance::included)
    s.refuse("rail.structural",
             "how a rail of sections bends as a whole no influence file of a section knows",
             "Leave it out: structural = \"removed\".");
  if (f.wheel.influence.empty())
    s.refuse("rail.sections", "sections have influence files, and the wheel has none",
             "Give wheel.influence too, or leave them out.");
  std::map<std::string, std::pair<int, int>> of_bodies; // sections, and those with a file
  for (std::size_t i = 0; i < f.rail.sections.size(); ++i) {
    const SceneFile::Section& section = f.rail.sections[i];
    auto& [all, with] = of_bodies[section.body];
    ++all;
    with += section.influence.empty() ? 0 : 1;
    if (names_slices(section.profile))
      s.refuse("rail.sections",
               fmt::format("section {} is a slices file, and there are influence files", i + 1),
               "Give each section with its own profile.");
  }
  for (const auto& [name, count] : of_bodies)
    if (const auto [all, with] = count; with < std::min(all, 2))
      s.refuse("rail.sections",
               fmt::format("{} of the {} sections of {} have influence files", with, all,
                           name.empty() ? "the rail" : fmt::format("body '{}'", name)),
               "Give two sections or more of each body their files: the functions are blended between them.");
}

void check_sections(const SceneFile& f, const Schema& s) {
  check_list_of_sections(f.rail, "rail", s);
  check_list_of_sections(f.wheel, "wheel", s);
  check_bodies(f, s);
  const char *rail = key_of_sections(f.rail, true), *wheel = key_of_sections(f.wheel, false);
  const char* sections = rail ? rail : wheel;
  if (!sections)
    return;
  if (rail && wheel)
    s.refuse(wheel, fmt::format("{} is given too", rail), "Give sections of one of the two bodies.");
  for (const auto& [given, key] : {std::pair{f.wheel.flat.given(), "wheel.flat"},
                                   {f.wheel.polygon.given(), "wheel.polygon"},
                                   {f.rail.joint.given() && rail, "rail.joint"}})
    if (given)
      s.refuse(sections, fmt::format("{} is given too", key),
               wheel ? "Let the sections have it."
                     : "Give a round wheel; a joint may be one of the sections.");
  if (f.solver.model == Model::simplified)
    s.refuse(sections, "the simplified theory takes the rail as level along x and the wheel as round",
             "Choose solver.model = \"halfspace\" or \"tangent_plane\".");
  if (f.motion.kind == MotionKind::shift && !f.motion.frictionless)
    s.refuse(sections, "shifts are those of bodies that are the same along x",
             "Choose motion.kind = \"steady\".");
  if (f.solver.contact_motion != ContactMotion::linear)
    s.refuse(sections, "solver.contact_motion places bodies that are the same along x",
             "Leave out solver.contact_motion.");
}

} // namespace

void add_sections(Schema& s, SceneFile::Side& side, const std::string& name) {
  const bool rail = name == "rail";
  const std::string list = name + ".sections";
  const auto row_of = [list, rail](SceneFile::Section& section) {
    Schema row(rail ? "section of a rail" : "section of a wheel");
    row.add(list + ".at", section.at,
            rail ? "Place of the section along the track, as position.along"
                 : "Angle of the section on the wheel, as wheel.flat.angle",
            {.unit = rail ? "mm" : "rad", .at_least = -1e7, .at_most = 1e7, .needed = true});
    row.add(list + ".profile", section.profile, "A standard or a profile file", {.needed = true});
    row.add(list + ".features", section.features,
            "Arc lengths on the profile of the lines along which sections are joined, in the same "
            "order in all; none: found",
            {.unit = "mm", .at_least = -1e5, .at_most = 1e5});
    row.add(list + ".without", section.without,
            "Numbers of those lines, from 1, that this section does not have; none: it has all");
    row.add(list + ".kink", section.kink,
            "The surface has an edge across the way here: its slope along it may jump");
    if (rail)
      row.add(list + ".body", section.body,
              "Of several rails beside each other, as wing and nose or stock rail and blade, the name of the "
              "one that has this section; empty: there is one");
    if (rail)
      row.add(list + ".influence", section.influence,
              "Influence file (HDF5) of a rail that is all along as it is here: between two sections with "
              "files the influence functions are blended");
    return row;
  };
  s.add(list,
        {[&side] { side.sections.clear(); }, [&side, row_of] { return row_of(side.sections.emplace_back()); },
         rail ? "[{ at = 0, profile = \"60E1\" }, { at = 500, profile = \"worn.prr\" }, ...]"
              : "[{ at = 0, profile = \"S1002\" }, { at = 3.1, profile = \"worn.prw\" }, ...]",
         [&side, row_of] {
           std::vector<Schema> rows;
           for (SceneFile::Section& section : side.sections)
             rows.push_back(row_of(section));
           return rows;
         }},
        rail ? "Instead of rail.profile: sections of a rail that changes along the track, by rising place; "
               "all have the same origin, and gauge and top are those of the first"
             : "Instead of wheel.profile: sections of a wheel that changes round its axle, by rising angle "
               "within one turn; all have their tape circle at y = 0, z = 0",
        {.kinds = wheel_rail_alone, .commented_out = true});
  if (!rail)
    s.add("wheel.sections_angle", side.sections_angle,
          "Where angle 0 of the sections is when position.along is 0: 0 below the axle, growing forwards",
          {.unit = "rad", .at_least = -1e3, .at_most = 1e3, .kinds = wheel_rail_alone});
}

void add_bodies(Schema& s, SceneFile::Side& rail) {
  const auto row_of = [](SceneFile::Body& body) {
    Schema row("body of a rail");
    row.add("rail.bodies.name", body.name, "As its sections have it", {.needed = true});
    row.add("rail.bodies.lowered", body.lowered, "It lies lower than its sections by this",
            {.unit = "mm", .at_least = -50, .at_most = 50});
    row.add("rail.bodies.stiffness", body.stiffness,
            "Vertical stiffness of what it lies on; bodies share the load by it; 0: rigid",
            {.unit = "N/mm", .at_least = 0, .zero_is_none = true});
    return row;
  };
  s.add("rail.bodies",
        {[&rail] { rail.bodies.clear(); }, [&rail, row_of] { return row_of(rail.bodies.emplace_back()); },
         "[{ name = \"wing\", stiffness = 1e5 }, { name = \"nose\", stiffness = 2e5 }, ...]",
         [&rail, row_of] {
           std::vector<Schema> rows;
           for (SceneFile::Body& body : rail.bodies)
             rows.push_back(row_of(body));
           return rows;
         }},
        "What several rails beside each other lie on, by the names that their sections give them",
        {.kinds = wheel_rail_alone, .commented_out = true});
}

void check_unevenness(const SceneFile& f, const Schema& s) {
  check_flat(f, s);
  check_polygon(f, s);
  check_joint(f, s);
  check_sections(f, s);
  const char *of_rail = key_of_sections(f.rail, true), *of_wheel = key_of_sections(f.wheel, false);
  const char* uneven = f.wheel.flat.given()      ? "wheel.flat"
                       : f.wheel.polygon.given() ? "wheel.polygon"
                       : f.rail.joint.given()    ? "rail.joint"
                       : of_rail                 ? of_rail
                                                 : of_wheel;
  if (!uneven)
    return;
  const auto refuse = [&](bool holds, const char* why, const char* what_to_do) {
    if (holds)
      s.refuse(uneven, why, what_to_do);
  };
  if (of_rail && !of_wheel && !f.wheel.flat.given() && !f.wheel.polygon.given()) {
    check_influence(f, s);
    refuse(!f.rail.has_influence() && (f.solver.model == Model::fem || !f.wheel.influence.empty()),
           "no section has an influence file",
           "Give two sections or more an influence file, { at = ..., profile = ..., influence = ... }, or "
           "choose solver.model = \"halfspace\" or \"tangent_plane\" and leave out wheel.influence.");
  } else
    refuse(f.solver.model == Model::fem || f.rail.has_influence() || !f.wheel.influence.empty(),
           "the influence functions of model \"fem\" are those of a round wheel, and of a rail that has no "
           "joint",
           "Choose solver.model = \"halfspace\" or \"tangent_plane\", and leave out the influence files.");
  refuse(f.rail.roller_radius.has_value(), "on a roller rig wheel and roller are taken as round",
         "Leave out rail.roller_radius.");
  refuse(f.motion.kind == MotionKind::transient && !f.motion.frictionless,
         "transient rolling has the same undeformed distance at each step, and here it changes",
         "Choose motion.kind = \"steady\" and sweep position.along: each place is then solved as if rolling "
         "were steady there.");
}

} // namespace bem_contact
