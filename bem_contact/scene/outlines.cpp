#include "bem_contact/scene/outlines.hpp"

#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/settings.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

Outlines profiles_near(const WheelRailGeometry& placed, double s_from, double s_to) {
  const WheelOnRail& pair = placed.pair;
  const CurvePoint first = pair.rail_at(s_from), last = pair.rail_at(s_to);
  const std::vector<double> wheel_s =
      placed.wheel_stations({{s_from, first.position, first.delta}, {s_to, last.position, last.delta}});
  const auto [lo, hi] = std::ranges::minmax(wheel_s);
  Outlines out;
  for (const TabulatedProfile::Node& node : pair.rail.nodes())
    if (node.s >= s_from - outline_margin && node.s <= s_to + outline_margin)
      out.rail.push_back(pair.rail_pose.to_track(node.position));
  for (const ContactLocus::Node& node : placed.locus.nodes())
    if (node.s >= lo - outline_margin && node.s <= hi + outline_margin)
      out.wheel.push_back(node.position);
  return out;
}

} // namespace

Outlines outlines(const ContactSetup& setup, const ContactProblem& problem) {
  if (setup.wheel_rail())
    return profiles_near(*setup.wheel_rail(), problem.rows.front().s, problem.rows.back().s);
  Outlines out;
  for (std::size_t is = 0; is < problem.rows.size(); ++is) {
    const ContactRow& row = problem.rows[is];
    const double gap = problem.gap[is * problem.grid.mx + problem.grid.mx / 2];
    out.rail.push_back(row.position);
    if (gap < excluded_gap)
      out.wheel.push_back(row.position - gap * normal_of(row.delta));
  }
  return out;
}

} // namespace bem_contact
