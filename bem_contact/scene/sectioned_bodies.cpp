#include "bem_contact/scene/sectioned_bodies.hpp"

#include "bem_contact/base/counted.hpp"
#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/messages.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/profile/sections/wheel_surface.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace bem_contact {

namespace {

/// mm. A body with one section reaches so far along the track: farther than any wheel of a scene.
constexpr double endless = 1e8;
/// 1. What is steeper, 60 degrees, is a side of a body and no part of its top: a blade lies against it.
/// Chosen.
constexpr double steepest_top = 1.7;
/// mm. Surfaces that lie closer are in one place: a wheel that touches one touches the other. Chosen.
constexpr double same_height = 0.5;
/// 1. So many warnings about the files of sections are said: they are mostly the same. Chosen.
constexpr std::size_t most_said = 3;
/// mm. Two bodies that have less in common touch or cross each other. Chosen.
constexpr double most_common_width = 2;

SectionsOfBody& body_named(std::vector<SectionsOfBody>& bodies, const std::string& name) {
  const auto known = std::ranges::find(bodies, name, &SectionsOfBody::name);
  return known != bodies.end() ? *known : bodies.emplace_back(SectionsOfBody{name, {}});
}

/// Those of a slices file, or one profile. Errors name the section.
SlicedBody sections_at(const SceneFile& scene, ProfileKind kind, std::size_t i) {
  const bool rail = kind == ProfileKind::rail;
  const SceneFile::Side& side = rail ? scene.rail : scene.wheel;
  const SceneFile::Section& section = side.sections[i];
  try {
    if (names_slices(section.profile)) {
      SlicedBody out =
          sections_of_slices(profile_file_name(section.profile, scene.folder).file, kind, side.reading);
      for (BodySection& one : out.sections)
        one.at += section.at;
      return out;
    }
    BodySection one{.at = section.at,
                    .profile = named_profile(section.profile, kind, scene.folder, side.reading),
                    .kink = section.kink};
    auto has = section.features.begin();
    for (std::size_t k = 1; k <= section.features.size() + section.without.size(); ++k)
      one.features.push_back(std::ranges::count(section.without, static_cast<double>(k)) > 0 ||
                                     has == section.features.end()
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : *has++);
    return {{std::move(one)}, false};
  } catch (const InputError& error) {
    throw InputError(fmt::format("Section {} of the {}, at {:g} {}: {}", i + 1, name_of(kind), section.at,
                                 rail ? "mm" : "rad", error.what()));
  }
}

SectionedSurface surface_of(SlicedBody body, ProfileKind kind) {
  return kind == ProfileKind::wheel
             ? wheel_surface(std::move(body.sections), body.approximated)
             : SectionedSurface(std::move(body.sections), {.approximated = body.approximated});
}

/// A body of several that has one section is the same all along the track.
void make_endless(std::vector<BodySection>& sections) {
  sections.push_back(sections.front());
  sections.front().at = -endless;
  sections.back().at = endless;
}

/// What of a body looks up, across the track: z over y, mm.
std::map<double, double> top_of(const SectionedSurface& surface, double u) {
  std::map<double, double> out;
  for (const double t : surface.nodes())
    if (surface.has(u, t))
      if (const SectionedSurface::Point p = surface.at(u, t);
          std::abs(p.by_t.z) < steepest_top * std::abs(p.by_t.y))
        out[p.position.y] = p.position.z;
  return out;
}

/// NaN beside it.
double height_at(const std::map<double, double>& top, double y) {
  const auto after = top.lower_bound(y);
  if (after == top.begin() || after == top.end())
    return std::numeric_limits<double>::quiet_NaN();
  const auto before = std::prev(after);
  return std::lerp(before->second, after->second, (y - before->first) / (after->first - before->first));
}

/// mm. How wide the top of one lies in the other's.
double common_width(const std::map<double, double>& one, const std::map<double, double>& other) {
  double out = 0;
  for (auto point = one.begin(); !one.empty() && std::next(point) != one.end(); ++point) {
    const auto next = std::next(point);
    const double y = (point->first + next->first) / 2, z = (point->second + next->second) / 2;
    if (std::abs(height_at(other, y) - z) < same_height)
      out += next->first - point->first;
  }
  return out;
}

/// Refuses two that are in one place: a wheel would be borne twice there.
void require_beside_each_other(const SectionedBodies& bodies, std::size_t a, std::size_t b) {
  const SectionedSurface &one = *bodies.surfaces[a], &other = *bodies.surfaces[b];
  std::vector<double> places = one.places();
  places.insert(places.end(), other.places().begin(), other.places().end());
  for (const double u : places) {
    if (u < std::max(one.from(), other.from()) || u > std::min(one.to(), other.to()) || u == endless)
      continue;
    const double width = common_width(top_of(one, u), top_of(other, u));
    if (width > most_common_width)
      throw InputError(
          fmt::format("Bodies '{}' and '{}' of the rail lie one upon the other", bodies.names[a],
                      bodies.names[b]),
          fmt::format("{} {:.1f} mm of their width are in one place, and a wheel would be borne twice there",
                      u == -endless ? "all along the track" : fmt::format("at {:g} mm along the track", u),
                      width),
          "Give sections that stand beside each other, cut where the other body covers them.");
  }
}

/// `bodies`: as they are given.
std::vector<SectionInfluence> influence_of(const SceneFile& scene,
                                           const std::vector<SectionsOfBody>& bodies) {
  std::vector<SectionInfluence> out;
  for (const SceneFile::Section& section : scene.rail.sections) {
    if (section.influence.empty())
      continue;
    const auto body = std::ranges::find(bodies, section.body, &SectionsOfBody::name);
    const auto& sections = body->body.sections;
    const ProfileCurve& profile = std::ranges::find(sections, section.at, &BodySection::at)->profile;
    const bool all_along = bodies.size() > 1 && sections.size() == 1;
    out.push_back({static_cast<int>(body - bodies.begin()), all_along, all_along ? -endless : section.at,
                   scene.folder / section.influence, profile.name(), profile.digest()});
  }
  std::ranges::stable_sort(out, {}, &SectionInfluence::body);
  return out;
}

/// Says the first of the warnings about many files, and how many more there are.
class FirstWarnings {
public:
  FirstWarnings() = default;
  FirstWarnings(const FirstWarnings&) = delete;
  FirstWarnings& operator=(const FirstWarnings&) = delete;
  ~FirstWarnings() {
    const std::vector<std::string> warnings = collected_->warnings();
    collected_.reset();
    for (std::size_t i = 0; i < std::min(warnings.size(), most_said); ++i)
      say(Importance::warning, warnings[i]);
    if (warnings.size() > most_said)
      say_warning("and {} about files of other sections (bem_contact profile FILE says what is about one)",
                  counted(warnings.size() - most_said, "more warning", "more warnings"));
  }

private:
  std::optional<CollectedMessages> collected_{std::in_place};
};

} // namespace

std::vector<SectionsOfBody> sections_of_bodies(const SceneFile& scene, ProfileKind kind) {
  const FirstWarnings warnings;
  const SceneFile::Side& side = kind == ProfileKind::rail ? scene.rail : scene.wheel;
  std::vector<SectionsOfBody> out;
  if (side.sections.empty() && names_slices(side.profile))
    out.push_back(
        {"", sections_of_slices(profile_file_name(side.profile, scene.folder).file, kind, side.reading)});
  for (std::size_t i = 0; i < side.sections.size(); ++i) {
    SlicedBody more = sections_at(scene, kind, i);
    SlicedBody& body = body_named(out, side.sections[i].body).body;
    std::ranges::move(more.sections, std::back_inserter(body.sections));
    body.approximated = body.approximated || more.approximated;
  }
  return out;
}

SectionedBodies sectioned_bodies(const SceneFile& scene, ProfileKind kind) {
  SectionedBodies out;
  std::vector<SectionsOfBody> bodies = sections_of_bodies(scene, kind);
  if (kind == ProfileKind::rail)
    out.influence = influence_of(scene, bodies);
  for (SectionsOfBody& one : bodies) {
    if (bodies.size() > 1 && one.body.sections.size() == 1)
      make_endless(one.body.sections);
    if (!out.first)
      out.first = one.body.sections.front().profile;
    out.names.push_back(one.name);
    try {
      out.surfaces.push_back(std::make_shared<const SectionedSurface>(surface_of(std::move(one.body), kind)));
    } catch (const InputError& error) {
      if (one.name.empty())
        throw;
      throw InputError(fmt::format("Body '{}' of the rail: {}", one.name, error.what()));
    }
    for (std::size_t before = 0; before + 1 < out.surfaces.size(); ++before)
      require_beside_each_other(out, before, out.surfaces.size() - 1);
  }
  return out;
}

} // namespace bem_contact
