#include "bem_contact/sequence/element_count.hpp"

#include "bem_contact/sequence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact {

namespace {

/// Rounded in the logarithm; `down`: not larger.
double on_ladder(double length, bool down) {
  const double step = sizes_per_octave * std::log2(length);
  return std::exp2((down ? std::floor(step + 1e-9) : std::round(step)) / sizes_per_octave); // 1e-9: rounding
}

} // namespace

ElementCount::ElementCount(int elements, double accuracy, int limit, int least)
    : accuracy_(accuracy), least_(least), usual_(elements > 0 ? elements : int(usual_elements)),
      wanted_(usual_) {
  const auto elements_for = [&](double error) {
    return usual_elements * (accuracy > 0 ? std::pow(error / accuracy, 1 / error_order) : 1.0);
  };
  const double needed = elements_for(usual_error);
  most_ = static_cast<int>(
      std::clamp(rare_factor * elements_for(rare_error), rare_factor * usual_elements, double(limit)));
  if (elements == 0)
    usual_ = wanted_ =
        static_cast<int>(std::clamp(needed, double(std::max(int(usual_elements), least)), double(limit)));
}

void ElementCount::forget() {
  wanted_ = std::min(wanted_, usual_);
}

bool ElementCount::learn(int contact, double error) {
  if (accuracy_ <= 0 || contact <= 0)
    return false;
  if (error < 0) { // nothing is known but that there are few
    const bool more = contact < most_ / 2 && wanted_ < most_;
    wanted_ = more ? std::min(most_, 2 * std::max(wanted_, contact)) : wanted_;
    return more;
  }
  const double needed = element_reserve * contact * std::pow(error / accuracy_, 1 / error_order);
  const bool again = error > accuracy_ && contact < most_;
  // Errors scatter: come down not at once, and go up by no more than a retry can correct.
  const double lo = (again ? least_retry : least_change) * contact, hi = most_change * contact;
  wanted_ = static_cast<int>(std::clamp(std::clamp(needed, lo, hi), double(least_), double(most_)));
  if (!again && wanted_ > usual_) // the next case may well be a usual one
    wanted_ = static_cast<int>(usual_ * std::pow(double(wanted_) / usual_, learnt_share));
  return again && wanted_ > contact;
}

std::pair<double, double> size_of_elements(const ContactEstimate& estimate, int elements, double area_ratio,
                                           double shortest, double longest) {
  const ContactExtent extent = contact_extent(estimate);
  if (!(extent.area > 0) || !(extent.along_x > 0) || !(extent.along_s > 0))
    return {default_dx, default_ds};
  const double element = extent.area * area_ratio / elements;
  // Behind the leading edge tractions grow over the shorter axis of a contact, whichever way that lies: long
  // elements in a contact drawn out along x, as at the gauge corner, cost three times the error.
  const double aspect = std::clamp(extent.along_x / extent.along_s, double(shortest_element_aspect), longest);
  // One is rounded to the nearest, the other such that there are not fewer elements than asked for.
  const double dx = std::max(shortest, on_ladder(std::sqrt(element * aspect), false));
  // Where dx may not follow, ever narrower rows would cost much and say little.
  const double narrowest = dx == shortest ? narrowest_element_share * shortest : 0;
  return {dx, std::max(narrowest, on_ladder(element / dx, true))};
}

} // namespace bem_contact
