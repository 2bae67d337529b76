#include "bem_contact/sequence/section_lines.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/scene/sectioned_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <vector>

namespace bem_contact {

namespace {

/// mm of t. Distance of the lines that are drawn between the feature lines.
constexpr double line_distance = 4;
/// 1. Points of a line between two sections.
constexpr int between_sections = 4;
/// rad. A wheel's sections are repeated beyond one turn.
constexpr double half_turn = 3.1416;

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
  const auto add_point = [&](std::initializer_list<double> row) {
    auto column = out.points.columns.begin();
    for (const double value : row)
      (column++)->values.push_back(value);
  };
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
      add_point({static_cast<double>(body), t, is_line ? 1.0 : 0.0,
                 std::ranges::count(sections, u) > 0 ? 1.0 : 0.0, u, p.y, p.z});
      first = std::isnan(first) ? u : first;
      last = u;
    }
    if (is_line && !std::isnan(first))
      out.words +=
          fmt::format("  line at t = {:7.2f} mm: from {:g} to {:g} {}, y from {:.2f} to {:.2f} mm\n", t,
                      first, last, unit, surface.at(first, t).position.y, surface.at(last, t).position.y);
  }
}

/// Without rows.
record::Table table_of_points() {
  return {"point",
          {{"body", "1", "of several beside each other, which one, from 1", {}, true},
           {"t", "mm", "counts across: points of the same t correspond"},
           {"line", "1", "1: on a feature line, given or found", {}, true},
           {"section", "1", "1: at the place of a section", {}, true},
           {"u", "mm", "along the track; of a wheel its angle, rad"},
           {"y", "mm", "across, in the frame of the files"},
           {"z", "mm", "down"}}};
}

} // namespace

std::optional<SectionLines> section_lines(const SceneFile& scene, const std::string& name) {
  if (scene.kind != SceneKind::wheel_rail || !(scene.rail.has_sections() || scene.wheel.has_sections()))
    return std::nullopt;
  SectionLines out{{}, table_of_points()};
  for (const ProfileKind kind : {ProfileKind::rail, ProfileKind::wheel}) {
    const bool wheel = kind == ProfileKind::wheel;
    if (!(wheel ? scene.wheel : scene.rail).has_sections())
      continue;
    const SectionedBodies bodies = sectioned_bodies(scene, kind);
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

} // namespace bem_contact
