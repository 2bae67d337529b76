#include "bem_contact/contact/coupled/tolerance_schedule.hpp"

#include "bem_contact/contact/coupled/settings.hpp"
#include "bem_contact/contact/settings.hpp"

#include <algorithm>

namespace bem_contact::contact {

namespace {

/// 1. If the pressure carries more than the prescribed force, the tolerance is multiplied by prescribed force
/// over pressure force, but at least by this: about 1 / largest_force_ratio.
constexpr double least_force_share = 0.03;

} // namespace

ToleranceSchedule::ToleranceSchedule(double asked, bool loose)
    : asked_(asked), now_(loose ? std::max(asked, loose_tolerance) : asked) {}

bool ToleranceSchedule::is_close(double change) const {
  return change <= settling_factor * asked_;
}

void ToleranceSchedule::tighten(double change, double remaining_change, double share) {
  const double finest = asked_ * std::clamp(share, least_force_share, 1.0),
               enough = std::min(loose_tolerance, tolerance_of_change * change);
  now_ = enough < final_tolerance_ratio * finest || is_close(remaining_change * change) ? finest : enough;
}

} // namespace bem_contact::contact
