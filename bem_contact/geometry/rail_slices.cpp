#include "bem_contact/geometry/rail_slices.hpp"

#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"

#include <algorithm>

namespace bem_contact {

namespace {

/// mm. A slice farther from the wheel is left out: three times the largest approach.
constexpr double farthest_slice = 3.0;
/// 1. Least curvature along x of a slice, in curvatures of the wheel: a yawed hollow wheel may have none, and
/// the estimate needs some. Uneven bodies have some of their own (NearestAlong).
constexpr double least_slice_curvature = 0.05;

} // namespace

std::vector<RailSlice> slice_rail(const WheelOnRail& pair, const ContactLocus& locus) {
  std::vector<ContactRow> rows;
  const auto& [origin, angle] = pair.rail_pose;
  const Turn turn(angle);
  int near = 0;
  for (double s = pair.rail.s_begin() + slice_width; s < pair.rail.s_end(); s += slice_width) {
    const CurvePoint p = pair.rail.quick(s, near);
    rows.push_back({s, origin + turn(p.position), p.delta + angle});
  }
  const std::vector<RowOnLocus> nearest = rows_on_locus(locus, rows, farthest_slice);
  std::vector<RailSlice> slices;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double least = pair.uneven ? 0 : least_slice_curvature / pair.wheel_radius;
    const double half = nearest[i].hit() ? std::max(nearest[i].half, least) : 1.0;
    slices.push_back({rows[i].s, rows[i].delta, std::cos(rows[i].delta), nearest[i].distance, nearest[i].x,
                      half, rows[i].position, nearest[i].rail_lower});
  }
  return slices;
}

} // namespace bem_contact
