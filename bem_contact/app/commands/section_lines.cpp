#include "bem_contact/app/commands/section_lines.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/base/input_file.hpp"
#include "bem_contact/base/toml.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/scene/sectioned_bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <vector>

namespace bem_contact::app {

namespace {

/// mm of t. Distance of the lines that are drawn between the feature lines.
constexpr double line_distance = 4;
/// 1. Points of a line between two sections.
constexpr int between_sections = 4;
/// rad. A wheel's sections are repeated beyond one turn.
constexpr double half_turn = 3.1416;

/// Whether a file is a scene whose rail or wheel is given by sections.
bool is_scene_of_sections(const std::string& name) {
  if (std::filesystem::path(name).extension() != ".toml" || !is_regular(name))
    return false;
  try {
    const toml::table file = parse_toml(read_text_file(name, "scene file"), name);
    return std::ranges::any_of(std::array{"rail", "wheel"}, [&](const char* side) {
      return file[side]["sections"] || names_slices(file[side]["profile"].value_or(std::string()));
    });
  } catch (const toml::parse_error&) { // whoever reads it as something else says what is wrong
    return false;
  }
}

/// Nothing of a file that is no scene, or a scene without sections.
std::optional<SceneFile> scene_of_sections(const std::string& name, const ProfileReading& reading) {
  if (const auto kind = kind_of_slices(name)) {
    SceneFile scene;
    SceneFile::Side& side = *kind == ProfileKind::wheel ? scene.wheel : scene.rail;
    side.profile = name;
    side.reading = reading;
    side.reading.keep_origin = true;
    return scene;
  }
  return is_scene_of_sections(name) ? std::optional(read_scene_file(name)) : std::nullopt;
}

/// The places of a surface, and some between them.
std::vector<double> places_of(const SectionedSurface& surface, bool wheel) {
  std::vector<double> out;
  const std::vector<double>& at = surface.places();
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (wheel && std::abs(at[i]) > half_turn)
      continue;
    for (int k = 1; i > 0 && !out.empty() && at[i] > at[i - 1] && k < between_sections; ++k)
      out.push_back(at[i - 1] + (at[i] - at[i - 1]) * k / between_sections);
    out.push_back(at[i]);
  }
  return out;
}

void add_surface(const SectionedSurface& surface, std::size_t body, bool wheel, SectionLines& out) {
  const std::vector<double>&lines = surface.lines(), &sections = surface.places();
  std::vector<double> all = lines;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k)
    for (double t = lines[k] + line_distance; t < lines[k + 1] - 0.5 * line_distance; t += line_distance)
      all.push_back(t);
  std::ranges::sort(all);
  const std::vector<double> places = places_of(surface, wheel);
  const char* unit = wheel ? "rad" : "mm";
  for (const double t : all) {
    const bool is_line = std::ranges::count(lines, t) > 0;
    double first = std::nan(""), last = first;
    for (const double u : places) {
      const auto [from, to] = surface.extent(u);
      if (t < from || t > to)
        continue;
      const Point2 p = surface.at(u, t, t < to ? 1 : -1).position;
      out.csv += fmt::format("{},{:.6g},{:d},{:d},{:.6g},{:.6f},{:.6f}\n", body, t, is_line,
                             std::ranges::count(sections, u) > 0, u, p.y, p.z);
      first = std::isnan(first) ? u : first;
      last = u;
    }
    if (is_line && !std::isnan(first))
      out.words +=
          fmt::format("  line at t = {:7.2f} mm: from {:g} to {:g} {}, y from {:.2f} to {:.2f} mm\n", t,
                      first, last, unit, surface.at(first, t).position.y, surface.at(last, t).position.y);
  }
}

} // namespace

std::optional<SectionLines> section_lines(const std::string& name, const ProfileReading& reading) {
  const std::optional<SceneFile> scene = scene_of_sections(name, reading);
  if (!scene)
    return std::nullopt;
  SectionLines out{{}, "body,t,line,section,u,y,z\n"};
  for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel}) {
    const bool wheel = kind == ProfileKind::wheel;
    if (!(wheel ? scene->wheel : scene->rail).has_sections())
      continue;
    const SectionedBodies bodies = sectioned_bodies(*scene, kind);
    for (std::size_t i = 0; i < bodies.surfaces.size(); ++i) {
      const SectionedSurface& surface = *bodies.surfaces[i];
      out.words += fmt::format("{}: the sections of a {}{}\n", name, name_of(kind),
                               bodies.names[i].empty() ? "" : fmt::format(", body '{}'", bodies.names[i]));
      out.words += fmt::format("  joined along {}\n", counted(surface.lines().size(), "line", "lines"));
      add_surface(surface, i + 1, wheel, out);
    }
  }
  return out;
}

} // namespace bem_contact::app
