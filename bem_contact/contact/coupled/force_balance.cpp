#include "bem_contact/contact/coupled/force_balance.hpp"

#include "bem_contact/contact/coupled/settings.hpp"

#include <algorithm>
#include <cmath>

namespace bem_contact::contact {

namespace {

/// 1. The bracket is bisected after a step longer than this share of the step before the last. Chosen.
constexpr double slow_balance_step = 0.5;

} // namespace

double ForceBalance::start(double pressed, double borne) {
  least_slope_ = least_start_slope;
  const double slope = std::max(borne / pressed, least_slope_);
  return std::clamp(pressed + (force_ - borne) / slope, force_ / largest_start_share,
                    largest_force_ratio * force_);
}

double ForceBalance::next(double pressed, double borne) {
  (borne < force_ ? low_ : high_) = pressed;
  if (last_ == 0)
    slope_ = std::max(borne / pressed, least_slope_);
  else if (std::abs(pressed - last_) > least_secant_step * loose_tolerance * pressed)
    slope_ = (borne - last_borne_) / (pressed - last_);
  double wanted = pressed + (force_ - borne) / slope_; // infinite or worse where the secant is flat
  last_ = pressed;
  last_borne_ = borne;
  if (high_ == 0) { // no bracket yet
    if (!(wanted > pressed && wanted < largest_force_step * pressed))
      wanted = largest_force_step * pressed;
    wanted = std::min(wanted, largest_force_ratio * force_);
  } else if (const auto [from, to] = std::minmax(low_, high_);
             to - from < loose_tolerance * pressed &&
             std::abs(wanted - pressed) < loose_tolerance * pressed) {
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
