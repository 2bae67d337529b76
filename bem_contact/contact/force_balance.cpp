#include "bem_contact/contact/force_balance.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

double ForceBalance::next(double pressed, double borne) {
  constexpr double largest_step = 4; // times: what a nearly flat secant may ask for
  (borne < force_ ? low_ : high_) = pressed;
  const double slope = (borne - last_borne_) / (pressed - last_);
  double wanted = pressed + (force_ - borne) / slope; // infinite or worse where the secant is flat
  last_ = pressed;
  last_borne_ = borne;
  if (high_ == 0) {
    if (!(wanted > pressed && wanted < largest_step * pressed))
      wanted = largest_step * pressed;
    wanted = std::min(wanted, most * force_);
  } else {
    const auto [from, to] = std::minmax(low_, high_);
    const bool narrows = step_before_ == 0 || std::abs(wanted - pressed) < 0.5 * step_before_;
    if (!(wanted > from && wanted < to && narrows))
      wanted = 0.5 * (from + to);
  }
  step_before_ = high_ == 0 ? 0 : step_;
  step_ = std::abs(wanted - pressed);
  return wanted;
}

} // namespace bem_contact::contact
