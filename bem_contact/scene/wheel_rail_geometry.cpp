#include "bem_contact/scene/wheel_rail_geometry.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rail_rows.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/profile/bodies/body_file.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/profile/standard_profiles.hpp"
#include "bem_contact/profile/worn/like_standard.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace bem_contact {

namespace {

/// From the distance of bodies that have moved to what it was before; `gap` is a field of the rows.
void take_back(const WheelRailGeometry& placed, const std::vector<ContactRow>& rows,
               std::vector<double>& gap) {
  const std::size_t columns = gap.size() / rows.size();
  const std::vector<double> rail_s = placed.rail_stations(rows), wheel_s = placed.wheel_stations(rows);
  for (std::size_t is = 0; is < rows.size(); ++is) {
    const double away = counted_twice(placed.pair, *placed.structure, rail_s[is], wheel_s[is]).z;
    const double added = placed.structure->lowered * std::cos(rows[is].delta) - away;
    for (std::size_t i = is * columns; i < (is + 1) * columns; ++i)
      if (gap[i] < excluded_gap)
        gap[i] += added;
  }
}

/// A body file gives its contact surface alone; that of a roller is no rail without its curvature along x.
void require_roller_for_its_body(const SceneFile& scene) {
  const auto file = profile_file_name(scene.rail.profile, scene.folder).file;
  if (is_standard_profile(scene.rail.profile) || file.extension() != ".toml" || scene.rail.roller_radius)
    return;
  if (const double radius = -reference_radius_of(read_body_file(file)); radius > 0)
    throw InputError(fmt::format("The rail '{}' is a roller", scene.rail.profile),
                     fmt::format("its axis lies {:g} mm below the origin of its section, and the scene has a "
                                 "straight rail",
                                 radius),
                     fmt::format("Give rail.roller_radius = {:g}, or a straight rail.", radius));
}

/// The profile of one of them; errors name it.
ProfileCurve profile_of_section(const SceneFile& scene, std::size_t i) {
  const SceneFile::Section& section = scene.rail.sections[i];
  try {
    return named_profile(section.profile, ProfileKind::rail, scene.folder, scene.rail.reading);
  } catch (const InputError& error) {
    throw InputError(fmt::format("Section {} of the rail, at {:g} mm: {}", i + 1, section.at, error.what()));
  }
}

/// None of a rail that is the same along the track.
std::vector<BodySection> sections_of(const SceneFile& scene) {
  if (names_slices(scene.rail.profile))
    return sections_of_slices(profile_file_name(scene.rail.profile, scene.folder).file, scene.rail.reading);
  std::vector<BodySection> sections;
  for (std::size_t i = 0; i < scene.rail.sections.size(); ++i) {
    const SceneFile::Section& section = scene.rail.sections[i];
    BodySection& out = sections.emplace_back(
        BodySection{.at = section.at, .profile = profile_of_section(scene, i), .kink = section.kink});
    auto has = section.features.begin();
    for (std::size_t k = 1; k <= section.features.size() + section.without.size(); ++k)
      out.features.push_back(std::ranges::count(section.without, static_cast<double>(k)) > 0 ||
                                     has == section.features.end()
                                 ? std::numeric_limits<double>::quiet_NaN()
                                 : *has++);
  }
  return sections;
}

} // namespace

RailInclination inclination_of_rail(const std::string& name, const ProfileCurve& rail) {
  return std::async(std::launch::deferred,
                    [standard = is_standard_profile(name), rail] { return standard ? 0 : rail_turn(rail); });
}

WheelRailProfiles read_profiles(const SceneFile& scene) {
  std::vector<BodySection> sections = sections_of(scene);
  const ProfileCurve rail = !sections.empty() ? sections.front().profile
                                              : named_profile(scene.rail.profile, ProfileKind::rail,
                                                              scene.folder, scene.rail.reading);
  require_roller_for_its_body(scene);
  return {rail, named_profile(scene.wheel.profile, ProfileKind::wheel, scene.folder, scene.wheel.reading),
          inclination_of_rail(scene.rail.profile, rail),
          sections.empty() ? nullptr : std::make_shared<const SectionedSurface>(std::move(sections))};
}

std::vector<ContactRow> WheelRailGeometry::rows(const GridPlan& plan) const {
  return plan.planes.empty() ? rail_rows(pair, plan.rows_s(), 0.5 * plan.ds)
                             : planar_rows(pair, plan.rows_s(), plan.planes);
}

std::vector<double> WheelRailGeometry::rail_stations(const std::vector<ContactRow>& rows) const {
  std::vector<double> s;
  for (const ContactRow& row : rows)
    s.push_back(planar ? pair.rail.nearest(pair.rail_pose.to_section(row.position)).s : row.s);
  return s;
}

std::vector<double> WheelRailGeometry::wheel_stations(const std::vector<ContactRow>& rows) const {
  return bem_contact::wheel_stations(locus, rows);
}

std::vector<double> WheelRailGeometry::gap(const GridPlan& plan, const std::vector<ContactRow>& rows) const {
  // Without yaw even bodies are symmetric in x: half of the columns are computed.
  const bool symmetric = pair.yaw == 0 && plan.x_centre == 0 && !pair.uneven && !pair.sections;
  const int computed = symmetric ? (plan.columns + 1) / 2 : plan.columns;
  std::vector<double> x = plan.grid().columns();
  x.resize(computed);
  const std::vector<double> half = undeformed_distance(pair, rows_on_locus(locus, rows), rows, x);
  std::vector<double> gap(plan.grid().size());
  for (int is = 0; is < plan.rows; ++is)
    for (int ix = 0; ix < plan.columns; ++ix)
      gap[is * plan.columns + ix] = half[is * computed + (ix < computed ? ix : plan.columns - 1 - ix)];
  if (structure)
    take_back(*this, rows, gap);
  return gap;
}

} // namespace bem_contact
