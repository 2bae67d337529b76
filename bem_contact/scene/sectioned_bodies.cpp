#include "bem_contact/scene/sectioned_bodies.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/sections/slices_file.hpp"
#include "bem_contact/profile/sections/wheel_surface.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace bem_contact {

namespace {

/// mm. A body with one section reaches so far along the track: farther than any wheel of a scene.
constexpr double endless = 1e8;

struct NamedBody {
  std::string name;
  SlicedBody body;
};

NamedBody& body_named(std::vector<NamedBody>& bodies, const std::string& name) {
  const auto known = std::ranges::find(bodies, name, &NamedBody::name);
  return known != bodies.end() ? *known : bodies.emplace_back(NamedBody{name, {}});
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

std::vector<NamedBody> named_bodies(const SceneFile& scene, ProfileKind kind) {
  const SceneFile::Side& side = kind == ProfileKind::rail ? scene.rail : scene.wheel;
  std::vector<NamedBody> out;
  if (side.sections.empty() && names_slices(side.profile))
    out.push_back(
        {"", sections_of_slices(profile_file_name(side.profile, scene.folder).file, kind, side.reading)});
  for (std::size_t i = 0; i < side.sections.size(); ++i) {
    SlicedBody more = sections_at(scene, kind, i);
    SlicedBody& body = body_named(out, side.sections[i].body).body;
    std::ranges::move(more.sections, std::back_inserter(body.sections));
    body.approximated = body.approximated || more.approximated;
  }
  if (out.size() > 1)
    for (NamedBody& one : out)
      if (std::vector<BodySection>& sections = one.body.sections; sections.size() == 1) {
        sections.push_back(sections.front());
        sections.front().at = -endless;
        sections.back().at = endless;
      }
  return out;
}

SectionedSurface surface_of(SlicedBody body, ProfileKind kind) {
  return kind == ProfileKind::wheel
             ? wheel_surface(std::move(body.sections), body.approximated)
             : SectionedSurface(std::move(body.sections), {.approximated = body.approximated});
}

} // namespace

SectionedBodies sectioned_bodies(const SceneFile& scene, ProfileKind kind) {
  SectionedBodies out;
  for (NamedBody& one : named_bodies(scene, kind)) {
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
  }
  return out;
}

} // namespace bem_contact
