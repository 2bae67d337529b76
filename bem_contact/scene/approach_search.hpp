#pragma once

#include "bem_contact/scene/settings.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace bem_contact {

/// The approach q at which a growing force(q), nearly q^1.5, is `wanted`. The power 2/3 of the force is
/// nearly linear.
template <class Force> double approach_for(double wanted, const Force& force) {
  const auto excess = [&](double q) {
    const double e = std::cbrt(std::pow(force(q) / wanted, 2)) - 1;
    return std::abs(e) < approach_tolerance ? 0.0 : e;
  };
  double lo = 0, hi = first_approach, at_lo = -1, at_hi = excess(hi);
  while (at_hi < 0 && hi < last_approach)
    lo = hi, at_lo = at_hi, hi *= 2, at_hi = excess(hi);
  if (at_hi <= 0)
    return hi;
  std::uintmax_t calls = approach_steps;
  const boost::math::tools::eps_tolerance<double> to_rounding;
  return boost::math::tools::toms748_solve(excess, lo, hi, at_lo, at_hi, to_rounding, calls).second;
}

} // namespace bem_contact
