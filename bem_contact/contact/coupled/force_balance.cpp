#include "bem_contact/contact/coupled/force_balance.hpp"

#include "bem_contact/contact/coupled/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

double ForceBalance::next(double pressed, double borne) {
  (borne < force_ ? low_ : high_) = pressed;
  if (std::abs(pressed - last_) > least_secant_step * noise_of_sums * pressed)
    slope_ = (borne - last_borne_) / (pressed - last_);
  double wanted = pressed + (force_ - borne) / slope_; // infinite or worse where the secant is flat
  last_ = pressed;
  last_borne_ = borne;
  if (high_ == 0) { // no bracket yet
    if (!(wanted > pressed && wanted < largest_force_step * pressed))
      wanted = largest_force_step * pressed;
    wanted = std::min(wanted, largest_force_ratio * force_);
  } else if (const auto [from, to] = std::minmax(low_, high_);
             to - from < noise_of_sums * pressed && std::abs(wanted - pressed) < noise_of_sums * pressed) {
    low_ = high_ = 0; // the bracket is noise: the sums were not precise
    (borne < force_ ? low_ : high_) = pressed;
  } else {
    const bool narrows = step_before_ == 0 || std::abs(wanted - pressed) < slow_balance_step * step_before_;
    if (!(wanted > from && wanted < to && narrows))
      wanted = 0.5 * (from + to);
  }
  step_before_ = high_ == 0 ? 0 : step_;
  step_ = std::abs(wanted - pressed);
  return wanted;
}

bool ForceBalance::at_the_most(double pressed, double borne) const {
  return pressed >= largest_force_ratio * force_ && borne < force_;
}

} // namespace bem_contact::contact
