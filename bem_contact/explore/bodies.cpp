#include "bem_contact/explore/bodies.hpp"

#include "bem_contact/base/enum_names.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/schema_text.hpp"
#include "bem_contact/explore/settings.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact::explore {

namespace {

[[noreturn]] void refuse_bodies(const std::string& why, const std::string& what_to_do) {
  throw InputError("The bodies of this scene cannot be made here", why, what_to_do);
}

/// mm. An element of 0.123 mm asks for influence functions of 0.1 mm: two digits are enough.
double rounded_down(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1);
  return std::floor(length / unit + 1e-9) * unit;
}

std::string reading_text(const ProfileReading& r) {
  std::string out;
  const auto add = [&](const char* key, const auto& value, const auto& usual) {
    if (value != usual)
      out += fmt::format("{} = {}\n", key, value);
  };
  const ProfileReading usual;
  add("smoothing", r.smoothing, usual.smoothing);
  add("nominal", toml_text(r.nominal), toml_text(usual.nominal));
  add("unit", toml_text(name_of(r.unit)), toml_text(name_of(usual.unit)));
  add("profile_z", toml_text(name_of(r.profile_z)), toml_text(name_of(usual.profile_z)));
  add("mirror", r.mirror, usual.mirror);
  if (r.flange_back)
    out += fmt::format("flange_back = {}\n", *r.flange_back);
  add("tape_circle", r.tape_circle, usual.tape_circle);
  return out;
}

/// Whole millimetres with room on both sides, in stations that are no wider than the rows.
std::string strip_text(const std::vector<double>& s, double ds) {
  const auto [first, last] = std::ranges::minmax(s);
  const double from = std::floor(first - ds / 2 - strip_room), to = std::ceil(last + ds / 2 + strip_room);
  const double stations = std::ceil((to - from) / ds - 1e-9);
  return fmt::format("[strip]\nfrom = {:g} # mm, arc length\nto = {:g}\nstation_width = {}\n", from + 0.0,
                     to + 0.0, (to - from) / stations);
}

std::string body_text(const char* side, const SceneFile::Side& of, const std::vector<double>& s,
                      const ContactGrid& grid) {
  return fmt::format(
      "# Made by bem_contact explore for the contact on its screen\ntolerance = {:g}\n\n[body]\nkind = "
      "\"{}\"\nprofile = {}\n{}\n[material]\nshear_modulus = {} # MPa\npoisson = "
      "{}\n\n{}\n[harmonic]\nshortest_dx = {:g} # mm\n",
      double(body_tolerance), side, toml_text(of.profile), reading_text(of.reading),
      of.material.shear_modulus, of.material.poisson, strip_text(s, grid.ds), rounded_down(grid.dx));
}

void require_usual_bodies(const SceneFile& scene) {
  if (scene.kind != SceneKind::wheel_rail)
    refuse_bodies("a patch has no bodies", "Begin with a wheel on a rail.");
  if (scene.rail.roller_radius)
    refuse_bodies("a roller is no rail", "Write its body file: data/bodies/roller.toml is an example.");
  constexpr double like = 0.01; // 1, what fem allows
  if (std::abs(scene.position.wheel_radius - wheel_reference_radius) > like * scene.position.wheel_radius)
    refuse_bodies(fmt::format("a wheel's body has a radius of {:g} mm, position.wheel_radius is {:g} mm",
                              wheel_reference_radius, scene.position.wheel_radius),
                  "Write a body file with an outline of its own: data/bodies/README.md.");
  for (const SceneFile::Side* side : {&scene.rail, &scene.wheel})
    if (side->profile.ends_with(".toml"))
      refuse_bodies(fmt::format("the body file '{}' is there already", side->profile),
                    "Compute its influence functions with mesh_body and fem_influence.");
}

} // namespace

std::vector<BodyToCompute> bodies_of(const SceneFile& scene, const SceneResult& solved) {
  require_usual_bodies(scene);
  std::vector<double> rail_s;
  for (const ContactRow& row : solved.problem.rows)
    rail_s.push_back(row.s);
  const ContactGrid& grid = solved.problem.grid;
  return {{"rail", body_text("rail", scene.rail, rail_s, grid)},
          {"wheel", body_text("wheel", scene.wheel, solved.bodies.wheel_s, grid)}};
}

} // namespace bem_contact::explore
