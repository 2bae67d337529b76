#include "bem_contact/scene/outlines.hpp"

#include "bem_contact/geometry/undeformed_distance.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact {

namespace {

/// mm. How much of both profiles a picture shows finely on either side of the rows.
constexpr double outline_margin = 12.0;
/// mm. Of the points that it shows of the rest: a fillet of 10 mm still looks round.
constexpr double outline_spacing = 1.0;

/// Every node between `from` and `to`, and beyond them one every outline_spacing.
struct Thinning {
  double from, to;
  double last = -std::numeric_limits<double>::infinity();

  bool keeps(double s) {
    if ((s < from || s > to) && s - last < outline_spacing)
      return false;
    last = s;
    return true;
  }
};

Outlines whole_profiles(const WheelRailGeometry& placed, double s_from, double s_to) {
  const WheelOnRail& pair = placed.pair;
  const CurvePoint first = pair.rail_at(s_from), last = pair.rail_at(s_to);
  const std::vector<double> wheel_s =
      placed.wheel_stations({{s_from, first.position, first.delta}, {s_to, last.position, last.delta}});
  const auto [lo, hi] = std::ranges::minmax(wheel_s);
  Outlines out;
  const Turn turn(pair.rail_pose.angle);
  Thinning rail{s_from - outline_margin, s_to + outline_margin};
  for (const TabulatedProfile::Node& node : pair.rail.nodes())
    if (rail.keeps(node.s))
      out.rail.push_back(pair.rail_pose.origin + turn(node.position));
  Thinning wheel{lo - outline_margin, hi + outline_margin};
  for (const ContactLocus::Node& node : placed.locus.nodes())
    if (wheel.keeps(node.s))
      out.wheel.push_back(node.position);
  return out;
}

} // namespace

Outlines outlines(const ContactSetup& setup, const ContactProblem& problem) {
  if (setup.wheel_rail())
    return whole_profiles(*setup.wheel_rail(), problem.rows.front().s, problem.rows.back().s);
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
