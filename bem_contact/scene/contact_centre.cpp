#include "bem_contact/scene/contact_centre.hpp"

#include "bem_contact/geometry/rigid_slip.hpp"
#include "bem_contact/geometry/settings.hpp"
#include "bem_contact/geometry/undeformed_distance.hpp"
#include "bem_contact/scene/approach_search.hpp"

#include <cmath>

namespace bem_contact {

namespace {

/// Force of a slice of the foundation, up to its stiffness: depth - half x^2 integrated over x.
double foundation(const RailSlice& c, double q) {
  const double depth = c.depth(q);
  return depth > 0 ? 4.0 / 3 * depth * std::sqrt(depth / c.half) * slice_width : 0.0;
}

/// The slice nearest to s among those that `take` chooses; there is one.
template <class Take>
const RailSlice& nearest_slice(std::span<const RailSlice> slices, double s, const Take& take) {
  const RailSlice* nearest = nullptr;
  for (const RailSlice& c : slices)
    if (take(c) && (!nearest || std::abs(c.s - s) < std::abs(nearest->s - s)))
      nearest = &c;
  return *nearest;
}

/// Between a wing and a nose there is a flangeway: a centre there goes to the nearest place that bears.
void leave_gaps(std::span<const RailSlice> slices, double q, ContactCentre& centre) {
  const RailSlice& here = nearest_slice(slices, centre.s, [](const RailSlice&) { return true; });
  if (here.gap < excluded_gap)
    return;
  const RailSlice& bears =
      nearest_slice(slices, centre.s, [&](const RailSlice& c) { return foundation(c, q) > 0; });
  centre.s = bears.s;
  centre.x = bears.x;
  centre.ahead = bears.ahead;
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
    centre.ahead += share * c.ahead;
    centre.rolling_radius +=
        share * (pair.uneven ? radius_at(frame, {c.x, c.position.y, c.position.z + c.rail_lower})
                             : radius_at(pair, frame, c.x, c.position));
  }
  if (!(sum > 0))
    return std::nullopt;
  centre = {centre.s / sum, centre.x / sum, centre.ahead / sum, centre.rolling_radius / sum};
  leave_gaps(slices, q, centre);
  return centre;
}

} // namespace bem_contact
