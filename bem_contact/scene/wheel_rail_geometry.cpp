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

/// The bodies of the rail side as they stand; null: the rail has one profile.
std::shared_ptr<const RailSurfaces> rail_surfaces(const SceneFile& scene, const SectionedBodies& rail) {
  if (rail.surfaces.empty())
    return nullptr;
  std::vector<RailSurfaces::Body> bodies;
  for (std::size_t i = 0; i < rail.surfaces.size(); ++i) {
    const auto known = std::ranges::find(scene.rail.bodies, rail.names[i], &SceneFile::Body::name);
    bodies.push_back({rail.surfaces[i], known != scene.rail.bodies.end() ? known->lowered : 0});
  }
  return std::make_shared<const RailSurfaces>(std::move(bodies));
}

} // namespace

RailInclination inclination_of_rail(const std::string& name, const ProfileCurve& rail) {
  return std::async(std::launch::deferred,
                    [standard = is_standard_profile(name), rail] { return standard ? 0 : rail_turn(rail); });
}

WheelRailProfiles read_profiles(const SceneFile& scene) {
  const auto profile_of = [&](const SceneFile::Side& side, ProfileKind kind, const SectionedBodies& bodies) {
    return bodies.first ? *bodies.first : named_profile(side.profile, kind, scene.folder, side.reading);
  };
  SectionedBodies of_rail = sectioned_bodies(scene, ProfileKind::rail),
                  of_wheel = sectioned_bodies(scene, ProfileKind::wheel);
  const ProfileCurve rail = profile_of(scene.rail, ProfileKind::rail, of_rail);
  require_roller_for_its_body(scene);
  return {rail, profile_of(scene.wheel, ProfileKind::wheel, of_wheel),
          inclination_of_rail(scene.rail.profile, rail), std::move(of_rail), std::move(of_wheel)};
}

WheelOnRail placed_bodies(const SceneFile& scene, const WheelRailProfiles& profiles,
                          const WheelsetPosition& position) {
  const auto& of_wheel = profiles.wheel_bodies.surfaces;
  return place(position, profiles.rail, profiles.wheel, rail_surfaces(scene, profiles.rail_bodies),
               of_wheel.empty() ? nullptr : of_wheel.front());
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
