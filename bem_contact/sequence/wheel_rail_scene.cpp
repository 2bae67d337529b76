#include "bem_contact/sequence/wheel_rail_scene.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/profile/read_profile.hpp"
#include "bem_contact/scene/motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <optional>

namespace bem_contact {

namespace {

constexpr double largest_approach = 1.0; // mm: a hundred times the load at which steel yields

void require_elastic(double approach) {
  if (approach > largest_approach)
    throw InputError("The load is far beyond elastic contact",
                     fmt::format("the bodies would approach by about {:.3g} mm", approach),
                     "Check load and units (N, mm).");
}

/// Lets shear bear its part of the load: as if all slipped, less of it where creepages are small.
void add_shear(WheelRailScene& placed, const SceneFile& scene) {
  constexpr double small = 0.002; // creepage at which about half of a contact slips
  const SceneFile::Motion& motion = scene.motion;
  if (motion.frictionless || motion.kind == "shift" || !scene.load.has_force || !(scene.load.force > 0) ||
      scene.load.has_force_x || scene.load.has_force_s)
    return;
  ContactProblem point; // of one element, where a slice is nearest to the wheel
  point.grid = {1, 1, 1, 1, 0};
  for (const RailSlice& c : placed.estimate.slices) {
    if (c.gap >= largest_approach)
      continue;
    const CurvePoint p = placed.pair.rail_at(c.s);
    point.grid.x0 = c.x;
    point.rows = {{c.s, p.position, p.delta}};
    prescribe_step(point, scene, &placed, {});
    const double along_s = point.slip_s[0] / std::hypot(point.slip_x[0], point.slip_s[0], small);
    placed.estimate.lift[&c - placed.estimate.slices.data()] = std::clamp(1 + motion.friction * along_s * std::tan(c.delta), 0.05, 4.0);
  }
  estimate_with_shear(placed.estimate, scene.rail.material, scene.wheel.material, scene.load.force,
                      2 * largest_approach); // an overestimate costs a grid that is too coarse
}

} // namespace

WheelRailProfiles read_profiles(const SceneFile& scene) {
  return {named_profile(scene.rail.profile, ProfileKind::rail, scene.folder),
          named_profile(scene.wheel.profile, ProfileKind::wheel, scene.folder)};
}

WheelsetPosition wheelset_of(const SceneFile::Position& p) {
  return {p.side == "left" ? WheelSide::left : WheelSide::right,
          p.lateral,
          p.gauge,
          p.gauge_height,
          p.back_to_back,
          p.cant,
          p.roll,
          p.yaw,
          p.wheel_radius,
          p.rail_lateral,
          p.rail_vertical,
          p.rail_roll};
}

WheelRailScene place_wheel_rail(const SceneFile& scene) {
  return place_wheel_rail(scene, read_profiles(scene));
}

WheelRailScene place_wheel_rail(const SceneFile& scene, const WheelRailProfiles& profiles,
                                bool foresee_shear) {
  if (scene.load.has_approach)
    require_elastic(scene.load.approach);
  WheelOnRail pair = place(wheelset_of(scene.position), profiles.rail, profiles.wheel);
  const double before = pair.wheel_pose.origin.z;
  std::vector<TouchPoint> touch = lower_to_touch(pair);
  const double lowered = pair.wheel_pose.origin.z - before;
  ContactLocus locus(pair);
  WheelRailScene out{std::move(pair), std::move(locus), std::move(touch), {}, {}, 0, 0, {}};
  out.approach = scene.position.has_vertical ? scene.position.vertical - lowered : scene.load.approach;
  out.estimate = estimate_contact(out.pair, out.locus, scene.rail.material, scene.wheel.material,
                                  scene.load.force, out.approach, !scene.load.has_force);
  if (out.estimate.touching) {
    const CurvePoint p = out.pair.rail_at(out.estimate.s);
    out.reference = {p.position, p.s, p.delta, out.estimate.x};
    out.rolling_radius = out.estimate.rolling_radius;
  } else {
    const TouchPoint& deepest = out.touch.front();
    out.reference = {deepest.position, deepest.rail_s, deepest.delta, deepest.x};
    out.rolling_radius = out.pair.wheel_radius + out.pair.wheel.at(deepest.wheel_s).position.z;
  }
  if (scene.motion.rolling_radius > 0)
    out.rolling_radius = scene.motion.rolling_radius;
  else if (scene.motion.pitch_rate > 0)
    out.rolling_radius = scene.motion.speed / scene.motion.pitch_rate;
  require_elastic(out.estimate.approach);
  if (foresee_shear)
    add_shear(out, scene);
  return out;
}

GridPlan plan_wheel_rail(const WheelRailScene& placed, const SceneFile& scene, const PairFiles& files) {
  const double origin = files.rail ? files.rail->stations.front().s : 0.5 * scene.grid.ds;
  return plan_grid(placed.estimate, scene.grid, origin);
}

PreparedContact prepare_wheel_rail(const WheelRailScene& placed, const SceneFile& scene) {
  const GridPlan& plan = placed.plan;
  PreparedContact out;
  ContactProblem& problem = out.problem;
  problem.grid = {plan.columns, plan.rows, plan.dx, plan.ds, plan.x0()};
  const bool planar = scene.grid.planar;
  problem.rows = planar ? planar_rows(placed.pair, plan.rows_s(), placed.reference)
                        : rail_rows(placed.pair, plan.rows_s(), 0.5 * plan.ds);

  // Without yaw symmetric in x: half of the columns are computed.
  const bool symmetric = placed.pair.yaw == 0 && plan.x_centre == 0;
  const int computed = symmetric ? (plan.columns + 1) / 2 : plan.columns;
  std::vector<double> x(computed);
  for (int ix = 0; ix < computed; ++ix)
    x[ix] = problem.grid.x(ix);
  const std::vector<double> gap =
      undeformed_distance(placed.pair, rows_on_locus(placed.locus, problem.rows), problem.rows, x);
  problem.gap.resize(problem.grid.size());
  for (int is = 0; is < plan.rows; ++is)
    for (int ix = 0; ix < plan.columns; ++ix)
      problem.gap[is * plan.columns + ix] = gap[is * computed + (ix < computed ? ix : plan.columns - 1 - ix)];

  set_motion(problem, scene, placed.reference.delta);
  if (problem.tangential)
    prescribe_step(problem, scene, &placed, {});

  for (const ContactRow& row : problem.rows)
    out.rail_s.push_back(planar ? placed.pair.rail.nearest(placed.pair.rail_pose.to_section(row.position)).s
                                : row.s);
  out.wheel_s = wheel_stations(placed.locus, problem.rows);
  // A smooth function of the position: not that of the deepest point.
  out.contact_radius = placed.estimate.touching ? placed.estimate.rolling_radius : placed.pair.wheel_radius;
  return out;
}

std::pair<std::vector<Point2>, std::vector<Point2>> profiles_near(const WheelRailScene& placed, double s_from,
                                                                  double s_to) {
  constexpr double margin = 12;
  const WheelOnRail& pair = placed.pair;
  const CurvePoint first = pair.rail_at(s_from), last = pair.rail_at(s_to);
  const std::vector<ContactRow> ends{{s_from, first.position, first.delta},
                                     {s_to, last.position, last.delta}};
  const std::vector<double> wheel_s = wheel_stations(placed.locus, ends);
  const auto [lo, hi] = std::ranges::minmax(wheel_s);
  std::vector<Point2> rail, wheel;
  for (const TabulatedProfile::Node& node : pair.rail.nodes())
    if (node.s >= s_from - margin && node.s <= s_to + margin)
      rail.push_back(pair.rail_pose.to_track(node.position));
  for (const ContactLocus::Node& node : placed.locus.nodes())
    if (node.s >= lo - margin && node.s <= hi + margin)
      wheel.push_back(node.position);
  return {std::move(rail), std::move(wheel)};
}

std::vector<std::string> describe(const WheelRailScene& placed) {
  std::vector<std::string> lines;
  for (const TouchPoint& p : placed.touch)
    if (p.distance < 1.0)
      lines.push_back(fmt::format("touch point: rail s = {:.3f} mm, wheel s = {:.3f} mm, x = {:.3f} mm, y = "
                                  "{:.3f} mm, z = {:.3f} mm, "
                                  "inclination {:.2f} degrees, vertical distance {:.4f} mm",
                                  p.rail_s, p.wheel_s, p.x, p.position.y, p.position.z,
                                  p.delta * 180 / std::numbers::pi, p.distance));
  for (const PotentialArea& area : potential_areas(placed.estimate))
    lines.push_back(fmt::format("potential contact: s = {:.2f} .. {:.2f} mm, x = {:.2f} .. {:.2f} mm",
                                area.s_from, area.s_to, area.x_from, area.x_to));
  lines.push_back(fmt::format("estimate: approach {:.4f} mm, vertical force {:.0f} N",
                              placed.estimate.approach, placed.estimate.force));
  lines.push_back(fmt::format("reference point: s = {:.3f} mm, x = {:.3f} mm, inclination {:.2f} degrees; "
                              "rolling radius {:.3f} mm",
                              placed.reference.s, placed.reference.x,
                              placed.reference.delta * 180 / std::numbers::pi, placed.rolling_radius));
  return lines;
}

} // namespace bem_contact
