#include "bem_contact/wheelset/lateral_search.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/wheelset/settings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace bem_contact {

namespace {

/// Narrows an interval at whose ends the force is on different sides of `wanted`: where the line between both
/// meets it, but not too near to an end, because on a flange the force is no line.
LateralRoot narrow(const LateralForce& force, LateralSample a, LateralSample b, double wanted) {
  const double first_slope = (b.force - a.force) / (b.lateral - a.lateral);
  const auto met = [&] { return (wanted - a.force) / (b.force - a.force); };
  while (std::abs(b.lateral - a.lateral) > rough_lateral_width) {
    const double share = std::clamp(met(), least_narrowing, 1 - least_narrowing);
    const double between = a.lateral + share * (b.lateral - a.lateral);
    const std::optional<double> there = force(between);
    if (!there)
      break;
    ((*there - wanted) * (a.force - wanted) > 0 ? a : b) = {between, *there};
  }
  const double slope = (b.force - a.force) / (b.lateral - a.lateral);
  return slope > 0 ? LateralRoot{a.lateral + (wanted - a.force) / slope, slope}
                   : LateralRoot{a.lateral, first_slope}; // rough forces so near to each other say nothing
}

} // namespace

LateralRoot search_lateral(const LateralForce& force, double start, double wanted) {
  const std::optional<double> first = force(start);
  if (!first)
    throw InputError(fmt::format("The wheelset does not stand at a lateral displacement of {:g} mm", start),
                     "the search for the displacement that wheelset.force_y asks for begins there",
                     "Give another position.lateral.");
  const double side = *first < wanted ? 1 : -1;
  LateralSample here{start, *first}, best = here;
  double step = first_lateral_step;
  while (std::abs(here.lateral - start) < lateral_search_reach) {
    const double at = here.lateral + side * step;
    const std::optional<double> there = force(at);
    if (there && side * (*there - wanted) >= 0)
      return narrow(force, here, {at, *there}, wanted);
    if (!there) {
      step *= 0.5;
      if (step < least_lateral_step)
        break;
      continue;
    }
    here = {at, *there};
    if (side * (here.force - best.force) > 0)
      best = here;
    step = std::min(lateral_step_growth * step, largest_lateral_step);
  }
  throw InputError(
      fmt::format("No lateral displacement gives the wheelset a lateral force of {:g} N", wanted),
      fmt::format(
          "from {:g} mm on, the rails bear up to {:.5g} N, at {:.2f} mm; beyond that the flange climbs "
          "the rail or a wheel lifts",
          start, best.force, best.lateral),
      "Give a smaller wheelset.force_y, less friction, or another position.lateral.");
}

} // namespace bem_contact
