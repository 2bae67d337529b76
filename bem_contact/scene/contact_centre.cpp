#include "bem_contact/scene/contact_centre.hpp"

#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/scene/approach_search.hpp"

#include <cmath>

namespace bem_contact {

namespace {

/// Force of a slice of the foundation, up to its stiffness: depth - half x^2 integrated over x.
double foundation(const RailSlice& c, double q) {
  const double depth = c.depth(q);
  return depth > 0 ? 4.0 / 3 * depth * std::sqrt(depth / c.half) * slice_width : 0.0;
}

} // namespace

std::optional<ContactCentre> contact_centre(std::span<const RailSlice> slices, const WheelOnRail& pair,
                                            const WheelFrame& frame, double compliance,
                                            const ContactLoad& load) {
  const auto vertical = [&](double q) {
    double sum = 0;
    for (const RailSlice& c : slices)
      sum += foundation(c, q) * c.cosine;
    return sum / (compliance * foundation_depth);
  };
  const double q = load.kind == LoadKind::approach ? penetration_share * load.approach
                                                   : approach_for(load.force, vertical);
  double sum = 0;
  ContactCentre centre;
  for (const RailSlice& c : slices) {
    const double share = foundation(c, q);
    sum += share;
    centre.s += share * c.s;
    centre.x += share * c.x;
    centre.rolling_radius +=
        share * (pair.uneven ? radius_at(frame, {c.x, c.position.y, c.position.z + c.rail_lower})
                             : radius_at(pair, frame, c.x, c.position));
  }
  if (!(sum > 0))
    return std::nullopt;
  return ContactCentre{centre.s / sum, centre.x / sum, centre.rolling_radius / sum};
}

} // namespace bem_contact
