#pragma once

#include <complex>

namespace bem_contact {

/// Sums over n = first .. last of e^(i n angle) / (n step)^3 and / (n step)^4, for 0 <= angle <= pi.
/// Terms are added one by one until n angle >= expansion_phase (settings.hpp); the rest is the difference of
/// two infinite sums, each from its expansion in 1/n (Euler-Maclaurin where angle = 0): the cost does not
/// grow with `last`. Exact to 1e-13 of the sum for angle = 0.
struct TailSums {
  std::complex<double> cubes = 0, fourths = 0;
};
TailSums tail_sums(long first, long last, double step, double angle);

} // namespace bem_contact
