#include "bem_contact/sequence/plan/potential_area.hpp"

#include "bem_contact/sequence/plan/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// mm. Least approach for which a potential contact is planned: a grid is needed under no load too.
constexpr double smallest_approach = 1e-4;

} // namespace

ContactExtent contact_extent(const ContactEstimate& estimate) {
  ContactExtent out;
  if (estimate.slices.size() < 2)
    return out;
  const double ds = estimate.slices[1].s - estimate.slices[0].s;
  for (const RailSlice& c : estimate.slices) {
    const double depth = c.depth(estimate.penetration * estimate.approach);
    if (depth <= 0)
      continue;
    const double length = 2 * std::sqrt(depth / c.half);
    out.along_x = std::max(out.along_x, length);
    out.along_s += ds;
    out.area += length * ds;
  }
  return out;
}

std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate, double q) {
  std::vector<PotentialArea> areas;
  bool open = false;
  for (const RailSlice& c : estimate.slices) {
    const double depth = c.depth(q);
    if (depth > 0) {
      const double half_length = std::sqrt(depth / c.half);
      if (!open)
        areas.push_back({c.s, c.s, c.x - half_length, c.x + half_length});
      PotentialArea& area = areas.back();
      area.s_to = c.s;
      area.x_from = std::min(area.x_from, c.x - half_length);
      area.x_to = std::max(area.x_to, c.x + half_length);
    }
    open = depth > 0;
  }
  return areas;
}

std::vector<PotentialArea> potential_areas(const ContactEstimate& estimate) {
  const double share = potential_share + (estimate.penetration - penetration_share);
  return potential_areas(estimate, share * std::max(estimate.approach, smallest_approach));
}

} // namespace bem_contact
