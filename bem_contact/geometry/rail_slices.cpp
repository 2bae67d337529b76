#include "bem_contact/geometry/rail_slices.hpp"

#include "bem_contact/geometry/settings.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <limits>

namespace bem_contact {

namespace {

/// mm. A slice farther from the wheel is left out: three times the largest approach.
constexpr double farthest_slice = 3.0;
/// mm. The same of the prism of a rail of sections: its relief brings it so much nearer within the reach.
constexpr double farthest_prism = 12.0;
/// 1. How far from the locus the relief may take the nearest place along x, in radii of the wheel: a rail
/// that is steeper against the frame by 0.15.
constexpr double relief_reach = 0.15;
/// mm. Steps in which the relief is looked at: sections are farther apart than this.
constexpr double relief_step = 4.0;
/// mm. Over which the relief's curvature is taken: half of a contact.
constexpr double relief_curvature_length = 3.0;

} // namespace

RowOnLocus with_relief(const WheelOnRail& pair, const ContactRow& row, const RowOnLocus& prism) {
  if (!prism.hit())
    return prism;
  const auto distance = [&](double x) {
    const auto deeper = pair.sections->depth(x, row);
    return deeper ? prism.half * (x - prism.x) * (x - prism.x) + *deeper
                  : std::numeric_limits<double>::infinity();
  };
  const int steps = static_cast<int>(relief_reach * pair.wheel_radius / relief_step);
  double best = prism.x, least = distance(best);
  for (int i = -steps; i <= steps; ++i)
    if (const double x = prism.x + i * relief_step, d = distance(x); d < least)
      best = x, least = d;
  if (!std::isfinite(least))
    return {};
  const auto [x, refined] = boost::math::tools::brent_find_minima(
      [&](double at) { return std::min(distance(at), excluded_gap); }, best - relief_step, best + relief_step,
      std::numeric_limits<double>::digits / 2);
  if (refined < least)
    best = x, least = refined;
  RowOnLocus out = prism;
  out.x = best;
  out.distance += least;
  const auto deep = [&](double at) { return pair.sections->depth(at, row); };
  const auto before = deep(best - relief_curvature_length), here = deep(best),
             after = deep(best + relief_curvature_length);
  if (before && here && after)
    out.half += 0.5 * (*before - 2 * *here + *after) / (relief_curvature_length * relief_curvature_length);
  return out;
}

std::vector<RailSlice> slice_rail(const WheelOnRail& pair, const ContactLocus& locus) {
  std::vector<ContactRow> rows;
  const auto& [origin, angle] = pair.rail_pose;
  const Turn turn(angle);
  int near = 0;
  for (double s = pair.rail.s_begin() + slice_width; s < pair.rail.s_end(); s += slice_width) {
    const CurvePoint p = pair.rail.quick(s, near);
    rows.push_back({s, origin + turn(p.position), p.delta + angle});
  }
  std::vector<RowOnLocus> nearest =
      rows_on_locus(locus, rows, pair.sections ? farthest_prism : farthest_slice);
  if (pair.sections)
    for (std::size_t i = 0; i < rows.size(); ++i) {
      nearest[i] = with_relief(pair, rows[i], nearest[i]);
      const Vector3 p = pair.sections->point(nearest[i].x, rows[i]);
      rows[i].position = {p[1], p[2]};
      if (nearest[i].distance > farthest_slice)
        nearest[i] = {};
    }
  std::vector<RailSlice> slices;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double least = pair.uneven ? 0 : least_slice_curvature / pair.wheel_radius;
    const double half = nearest[i].hit() ? std::max(nearest[i].half, least) : 1.0;
    slices.push_back({rows[i].s, rows[i].delta, std::cos(rows[i].delta), nearest[i].distance, nearest[i].x,
                      half, rows[i].position, nearest[i].rail_lower, nearest[i].ahead});
  }
  return slices;
}

} // namespace bem_contact
