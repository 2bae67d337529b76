#include "bem_contact/contact/coupled/force_balance.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

double ForceBalance::next(double pressed, double borne) {
  constexpr double largest_step = 4; // times: what a nearly flat secant may ask for
  constexpr double noise = 1e-4;     // relative: what sums may be off that were not solved precisely
  (borne < force_ ? low_ : high_) = pressed;
  if (std::abs(pressed - last_) > 0.1 * noise * pressed)
    slope_ = (borne - last_borne_) / (pressed - last_);
  double wanted = pressed + (force_ - borne) / slope_; // infinite or worse where the secant is flat
  last_ = pressed;
  last_borne_ = borne;
  if (high_ == 0) {
    if (!(wanted > pressed && wanted < largest_step * pressed))
      wanted = largest_step * pressed;
    wanted = std::min(wanted, most * force_);
  } else if (const auto [from, to] = std::minmax(low_, high_);
             to - from < noise * pressed && std::abs(wanted - pressed) < noise * pressed) {
    low_ = high_ = 0; // a bracket of sums that were not precise
    (borne < force_ ? low_ : high_) = pressed;
  } else {
    const bool narrows = step_before_ == 0 || std::abs(wanted - pressed) < 0.5 * step_before_;
    if (!(wanted > from && wanted < to && narrows))
      wanted = 0.5 * (from + to);
  }
  step_before_ = high_ == 0 ? 0 : step_;
  step_ = std::abs(wanted - pressed);
  return wanted;
}

} // namespace bem_contact::contact
