#include "bem_contact/app/output/placed_standard.hpp"

#include "bem_contact/app/settings.hpp"

#include <algorithm>
#include <limits>

namespace bem_contact::app {

namespace {

/// Linear between measured depths; NaN beyond them.
double depth_between(const std::vector<PointOnNominal>& seen, double s) {
  const auto after = std::ranges::lower_bound(seen, s, {}, &PointOnNominal::s);
  if (after == seen.end() || (after == seen.begin() && after->s > s))
    return std::numeric_limits<double>::quiet_NaN();
  if (after == seen.begin())
    return after->depth;
  const PointOnNominal &a = *(after - 1), &b = *after;
  return a.depth + (b.depth - a.depth) * (s - a.s) / (b.s - a.s);
}

} // namespace

PlacedStandard placed_standard(const ProfileCurve& standard, const MeasuredProfile& measured, double step) {
  std::vector<Point2> points;
  for (const CurvePoint& p : points_along(measured.curve, profile_csv_step))
    points.push_back(p.position);
  PlacedStandard out{
      place_nominal(standard, points, measured.scatter_left()), points_along(standard, step), {}};
  std::vector<PointOnNominal> seen;
  for (const Point2 p : points)
    if (const PointOnNominal one = seen_from(standard, p, out.place); !one.beyond)
      seen.push_back(one);
  std::ranges::sort(seen, {}, &PointOnNominal::s);
  for (CurvePoint& p : out.points) {
    out.depth.push_back(depth_between(seen, p.s));
    p.position = out.place.to_measured(p.position);
    p.delta += out.place.angle;
  }
  return out;
}

} // namespace bem_contact::app
