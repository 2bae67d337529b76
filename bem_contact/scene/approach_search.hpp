#pragma once

#include "bem_contact/scene/settings.hpp"

#include <cmath>

namespace bem_contact {

/// The approach q at which a growing force(q), nearly q^1.5, is `wanted`: regula falsi (Illinois) in the
/// power 2/3 of the force, which is nearly linear.
template <class Force> double approach_for(double wanted, const Force& force) {
  const auto excess = [&](double q) { return std::cbrt(std::pow(force(q) / wanted, 2)) - 1; };
  double lo = 0, hi = first_approach, at_lo = -1, at_hi = excess(hi);
  while (at_hi < 0 && hi < last_approach)
    lo = hi, at_lo = at_hi, hi *= 2, at_hi = excess(hi);
  for (int i = 0; i < approach_steps && at_hi > 0 && hi - lo > approach_width; ++i) {
    const double q = lo - at_lo * (hi - lo) / (at_hi - at_lo), f = excess(q);
    if (std::abs(f) < approach_tolerance)
      return q;
    if (f > 0)
      hi = q, at_hi = f, at_lo *= 0.5;
    else
      lo = q, at_lo = f, at_hi *= 0.5;
  }
  return hi;
}

} // namespace bem_contact
