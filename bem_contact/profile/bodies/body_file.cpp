#include "bem_contact/profile/bodies/body_file.hpp"

#include "bem_contact/base/fnv1a.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/material_keys.hpp"
#include "bem_contact/base/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace bem_contact {

namespace {

TableList outline_of(BodyFile::Body& body) {
  return {[&body] { body.outline.clear(); },
          [&body] {
            auto& piece = body.outline.emplace_back();
            Schema s("piece of an outline");
            s.add("body.outline.to", piece.to, "The piece ends here, (y, z)", {.unit = "mm", .needed = true});
            s.add("body.outline.radius", piece.radius, "0: a line; > 0: convex, < 0: concave arc",
                  {.unit = "mm"});
            s.add("body.outline.group", piece.group, "What the piece is");
            return s;
          },
          "[{ to = [10, 0] }, { to = [0, 10], radius = 10, group = \"contact\" }, ...]"};
}

TableList holes_of(BodyFile::Body& body) {
  return {[&body] { body.holes.clear(); },
          [&body] {
            auto& hole = body.holes.emplace_back();
            Schema s("hole of an outline");
            s.add("body.holes.centre", hole.centre, "Centre (y, z)", {.unit = "mm", .needed = true});
            s.add("body.holes.radius", hole.radius, "Radius of the hole",
                  {.unit = "mm", .above = 0, .needed = true});
            s.add("body.holes.group", hole.group, "What it is");
            return s;
          },
          "[{ centre = [0, 0], radius = 5, group = \"held\" }, ...]"};
}

void add_outline(Schema& s, BodyFile::Body& body) {
  SchemaTable t(s, "body", {"outline"});
  t.add("name", body.name, "Name of the body and of its contact profile");
  t.add("reference_radius", body.reference_radius,
        "0: prismatic; else of revolution about an axis this far above z = 0, or below it where negative",
        {.unit = "mm"});
  t.add("outline", outline_of(body),
        "Closed loop of lines and arcs (radius > 0 convex, < 0 concave, at most half a circle), each "
        "from the end of the one before; drawn with y to the right and z down the material is on the "
        "right hand",
        {.unit = "mm"});
  t.add("holes", holes_of(body), "Round holes", {.unit = "mm"});
}

void add_body(Schema& s, BodyFile::Body& body) {
  SchemaTable t(s, "body");
  t.add("kind", body.kind, "Kind of body");
  t.add("profile", body.profile,
        "A standard (bem_contact profile --list; a wheel's default: S1002) or a profile file",
        {.kinds = {"rail", "wheel"}});
  add_profile_reading(s, "body", body.reading, {"rail", "wheel"});
  add_flange_back(s, "body", body.reading, {"wheel"});
  add_tape_circle(s, "body", body.reading.tape_circle, {"wheel"});
  t.add("graft_onto", body.graft_onto,
        "Of a profile file: the standard whose body carries it; empty: 60E1 or S1002",
        {.kinds = {"rail", "wheel"}});
  t.add("graft_at", body.graft_at,
        "Where that standard's origin lies in the file's frame, (y, z); found where neither this nor "
        "graft_angle is given",
        {.unit = "mm", .kinds = {"rail", "wheel"}});
  t.add("graft_angle", body.graft_angle,
        "How its body is turned there, from +y towards +z (a rail inclined by 1:40: -0.025)",
        {.unit = "rad", .at_least = -0.5, .at_most = 0.5, .kinds = {"rail", "wheel"}});
  t.add("held", body.held,
        "What is held: rail: foot or web, wheel: bore or rim, block: base or sides; empty: the first",
        {.kinds = {"rail", "wheel", "block"}});
  t.add("roller_radius", body.roller_radius,
        "0: a straight rail; else a roller's, of revolution about an axis this far below z = 0",
        {.unit = "mm", .at_least = 0, .kinds = {"rail"}});
  t.add("radius", body.radius, "Radius of the contact surface",
        {.unit = "mm", .above = 0, .kinds = {"disc", "bore"}});
  t.add("size", body.size, "Half width and depth of the block",
        {.unit = "mm", .above = 0, .kinds = {"block", "bore"}});
  add_outline(s, body);
}

void add_strip(Schema& s, BodyFile::Strip& strip) {
  SchemaTable t(s, "strip");
  t.add("from", strip.from, "The contact strip begins here, arc length on the profile (a wheel: 20)",
        {.unit = "mm"});
  t.add("to", strip.to, "The contact strip ends here (a wheel: 50)", {.unit = "mm"});
  t.add("station_width", strip.station_width, "Width of a station; it must divide the strip",
        {.unit = "mm", .above = 0});
}

void add_mesh(Schema& s, BodyFile::Mesh& mesh) {
  SchemaTable t(s, "mesh");
  t.add("elements_per_station", mesh.elements_per_station, "Element edges per station on the strip",
        {.at_least = 1, .at_most = 16});
  t.add("grading", mesh.grading, "Element size grows by this much per mm of distance from the strip",
        {.above = 0, .at_most = 2, .commented_out = true});
  t.add("largest", mesh.largest, "Largest element size", {.unit = "mm", .above = 0});
}

void add_harmonic(Schema& s, BodyFile::Harmonic& harmonic) {
  SchemaTable t(s, "harmonic");
  t.add("degree", harmonic.degree, "Degree of the finite elements",
        {.at_least = 1, .at_most = 4, .commented_out = true});
  t.add("border_levels", harmonic.border_levels,
        "How often elements at the borders of the stations are halved",
        {.at_least = 0, .at_most = 12, .commented_out = true});
  t.add("half_period", harmonic.half_period,
        "Half period of the Fourier series along x; a body of revolution uses pi times its radius",
        {.unit = "mm", .above = 0});
  t.add("shortest_dx", harmonic.shortest_dx, "Shortest element length along x that the file must serve",
        {.unit = "mm", .above = 0});
  t.add("samples_per_decade", harmonic.samples_per_decade,
        "Wavenumbers per decade above the lowest harmonics",
        {.at_least = 2, .at_most = 100, .commented_out = true});
  t.add("remote_distance", harmonic.remote_distance,
        "The remote section lies between one and two times this from the strip; 0: 20 mm, or less "
        "in a small body",
        {.unit = "mm", .at_least = 0});
}

void add_stress(Schema& s, BodyFile::Stress& stress) {
  SchemaTable t(s, "stress");
  t.add("depths", stress.depths,
        "Stresses inside the body under unit loads are kept as well, in so many depths (20 are a good "
        "choice); 0: none",
        {.at_least = 0, .at_most = 100});
  t.add("deepest", stress.deepest, "The deepest of them; they get denser towards the surface",
        {.unit = "mm", .above = 0, .at_most = 200});
  t.add("beyond", stress.beyond, "So far beside the strip there are points, too",
        {.unit = "mm", .at_least = 0});
}

void add_solid(Schema& s, BodyFile::Solid& solid) {
  SchemaTable t(s, "solid");
  t.add("size", solid.size,
        "3-D method: element size on the strip before the mesh is refined towards the load",
        {.unit = "mm", .above = 0});
  t.add("edge_angle", solid.edge_angle, "Edges of that mesh on an arc turn by at most so much",
        {.unit = "deg", .at_least = 1, .at_most = 45});
  t.add("degree", solid.degree, "Degree of the finite elements", {.at_least = 1, .at_most = 4});
  t.add("dx", solid.dx, "Element length along x; 0: the station width", {.unit = "mm", .at_least = 0});
  t.add("offsets", solid.offsets, "Influence numbers at x = 0, dx, .. (offsets - 1) dx",
        {.at_least = 1, .at_most = 2000});
  t.add("elements_per_load", solid.elements_per_load, "Element edges along each side of the loaded element",
        {.at_least = 1, .at_most = 64});
  t.add("grading", solid.grading,
        "Element size grows by this much per mm of distance from the loaded element",
        {.above = 0, .at_most = 2});
  t.add("loads_at_once", solid.loads_at_once, "Stations loaded on one refined mesh: more need more memory",
        {.at_least = 1});
}

Schema schema_of(BodyFile& f, double& young) {
  Schema s("body file");
  s.kind_is("body.kind");
  s.add("tolerance", f.tolerance,
        "Error asked for, of the influence number itself; it chooses what is not given of [mesh] and "
        "[harmonic]",
        {.at_least = 1e-5, .at_most = 0.05});
  add_body(s, f.body);
  add_material(s, "material", f.material, young);
  add_strip(s, f.strip);
  add_mesh(s, f.mesh);
  add_harmonic(s, f.harmonic);
  add_stress(s, f.stress);
  add_solid(s, f.solid);
  return s;
}

void cross_check(const BodyFile& f, const Schema& s) {
  const auto& strip = f.strip;
  const double width = strip.to - strip.from;
  if (!(width > 0))
    s.refuse(s.has("strip.to") ? "strip.to" : "strip.from",
             fmt::format("the strip runs from {} to {} mm", strip.from, strip.to),
             "Give strip.to greater than strip.from.");
  constexpr double most_stations = 2000; // 9 GB of kernel at 32 wavenumbers
  const double stations = width / strip.station_width;
  const double whole = std::max(1.0, std::round(stations));
  if (stations > most_stations)
    s.refuse("strip.station_width",
             fmt::format("that makes {:.0f} stations, at most 2000 are served", stations),
             "Use wider stations or a shorter strip.");
  if (std::abs(stations - whole) > 1e-6)
    s.refuse("strip.station_width",
             fmt::format("it does not divide the strip of {:.10g} mm: {:.6g} stations", width, stations),
             fmt::format("Use {:.10g} for {:.0f} stations, or move strip.from or strip.to.", width / whole,
                         whole));

  const auto& body = f.body;
  if (f.body.profile.empty())
    s.refuse("body.profile", "the name is empty", "Name a standard profile or a profile file.");
  if (body.kind == BodyKind::bore && !(body.size > body.radius))
    s.refuse("body.size", fmt::format("the bore of radius {} mm does not fit into the block", body.radius),
             "Give a size greater than the radius.");
  const auto held_ok = [&](const char* first, const char* second) {
    if (!body.held.empty() && body.held != first && body.held != second)
      s.refuse("body.held",
               fmt::format("a {} is held at its {} or its {}", name_of(body.kind), first, second),
               fmt::format("Use \"{}\" or \"{}\".", first, second));
  };
  if (body.kind == BodyKind::rail)
    held_ok("foot", "web");
  if (body.kind == BodyKind::wheel)
    held_ok("bore", "rim");
  if (body.kind == BodyKind::block)
    held_ok("base", "sides");
  constexpr int least_depths = 4; // between which is interpolated
  const double least = 4 * strip.station_width;
  if (f.stress.depths != 0 && f.stress.depths < least_depths)
    s.refuse("stress.depths", "between fewer than four stresses cannot be interpolated",
             "Give 20, or 0 for none.");
  if (f.stress.depths != 0 && f.stress.deepest < least)
    s.refuse("stress.deepest", "the least depth is 1.5 stations, and the deepest lies well below it",
             fmt::format("Give {:g} mm or more.", least));
  const double reach = body.kind == BodyKind::block ? body.size
                       : body.kind == BodyKind::disc || body.kind == BodyKind::bore
                           ? std::numbers::pi / 2 * body.radius
                           : 0;
  if (reach > 0 && (strip.from < -reach || strip.to > reach))
    s.refuse(strip.from < -reach ? "strip.from" : "strip.to",
             fmt::format("the contact surface of this {} runs from {:.6g} to {:.6g} mm", name_of(body.kind),
                         -reach, reach),
             "Give a strip inside it.");
}

/// Of a wheel: the end of the tread and the flange root, opposite to a rail's default strip.
constexpr BodyFile::Strip usual_strip_of_wheel{.from = 20, .to = 50};

/// What the tolerance asks for, fitted to block, disc, rail and wheel (fem_influence/THEORY.md, sections 3
/// and 7): the number itself is off by 2.3 % (3/p)^4 / 4^levels with one element a station, far numbers by
/// 0.03 % at 7 samples a decade. Each gets a part of the tolerance that leaves room for the other.
void choose(BodyFile& f, const Schema& s) {
  if (!s.has("harmonic.degree"))
    f.harmonic.degree = f.tolerance < 3e-4 ? 4 : 3;
  if (!s.has("mesh.grading") && f.tolerance < 3e-4)
    f.mesh.grading = 0.2;
  if (!s.has("harmonic.border_levels")) {
    const double per_station = std::pow(f.mesh.elements_per_station, 2);
    const double unrefined = 0.023 * std::pow(3.0 / f.harmonic.degree, 4) / per_station;
    const double levels = std::ceil(std::log(10 * unrefined / f.tolerance) / std::log(4.0));
    f.harmonic.border_levels = std::clamp(static_cast<int>(levels), 0, 12);
  }
  if (!s.has("harmonic.samples_per_decade"))
    f.harmonic.samples_per_decade =
        static_cast<int>(std::ceil(7 * std::pow(1e-3 / f.tolerance, 1.0 / 6) - 1e-9));
}

} // namespace

BodyFile parse_body_file(std::string_view toml, std::string_view source_name) {
  BodyFile file;
  double young = 0;
  Schema schema = schema_of(file, young);
  schema.read(toml, source_name);
  settle_material(schema, "material", file.material, young);
  if (file.body.kind == BodyKind::wheel) {
    if (!schema.has("body.profile"))
      file.body.profile = "S1002";
    if (!schema.has("strip.from"))
      file.strip.from = usual_strip_of_wheel.from;
    if (!schema.has("strip.to"))
      file.strip.to = usual_strip_of_wheel.to;
  }
  cross_check(file, schema);
  choose(file, schema);
  return file;
}

BodyFile read_body_file(const std::filesystem::path& path) {
  BodyFile file = parse_body_file(read_text_file(path.string(), "body file"), path.string());
  file.folder = path.parent_path();
  return file;
}

std::vector<std::string> body_warnings(const BodyFile& file) {
  const bool rail = file.body.kind == BodyKind::rail, wheel = file.body.kind == BodyKind::wheel;
  const auto& [from, to, width] = file.strip;
  if (!(rail && from >= 0) && !(wheel && to <= 0))
    return {};
  return {
      fmt::format("the strip of this {0} ({1:g} .. {2:g} mm) lies on the field side, where {3} is not: the "
                  "arc length counts from the {4}. Give {5:g} .. {6:g} mm if the gauge side is meant.",
                  rail ? "rail" : "wheel", from, to, rail ? "its gauge corner" : "its flange",
                  rail ? "top of the rail to the field side" : "tape circle to the flange", -to, -from)};
}

double reference_radius_of(const BodyFile& body) {
  if (body.body.kind == BodyKind::outline)
    return body.body.reference_radius;
  if (body.body.kind == BodyKind::rail)
    return -body.body.roller_radius;
  return body.body.kind == BodyKind::wheel ? wheel_reference_radius : 0.0;
}

double half_period_of(const BodyFile& body) {
  const double radius = std::abs(reference_radius_of(body));
  return radius > 0 ? std::numbers::pi * radius : body.harmonic.half_period;
}

std::string mesh_digest(const BodyFile& file, std::uint64_t profile_digest) {
  const auto& [body, strip, mesh] = std::tie(file.body, file.strip, file.mesh);
  const Point2 graft_at = body.graft_at.value_or(Point2{});
  std::string all =
      fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {} {}", profile_digest, body.graft_onto,
                  graft_at.y, graft_at.z, body.graft_angle.value_or(0), body.held, name_of(body.kind),
                  body.profile, body.radius, body.size, body.reference_radius, strip.from, strip.to,
                  strip.station_width, mesh.elements_per_station, mesh.grading, mesh.largest);
  for (const auto& piece : body.outline)
    all += fmt::format(" {} {} {} {}", piece.to.y, piece.to.z, piece.radius, name_of(piece.group));
  for (const auto& hole : body.holes)
    all += fmt::format(" {} {} {} {}", hole.centre.y, hole.centre.z, hole.radius, name_of(hole.group));
  if (body.graft_at || body.graft_angle)
    all += " grafted there";
  if (body.roller_radius > 0)
    all += fmt::format(" roller {}", body.roller_radius);
  Fnv1a hash;
  hash.add(std::as_bytes(std::span(all)));
  return fmt::format("{:016x}", hash.value());
}

std::string default_body_file() {
  BodyFile file;
  double young = 0;
  return schema_of(file, young).print();
}

} // namespace bem_contact
