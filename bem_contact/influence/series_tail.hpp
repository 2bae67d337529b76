#pragma once

#include <complex>

namespace bem_contact {

/// Sum over n = first .. last of e^(i n angle) / (n step)^power, for 0 <= angle <= pi, power >= 2.
/// Terms are added one by one until n angle >= expansion_phase (settings.hpp); the rest is the difference of
/// two infinite sums, each from its expansion in 1/n (Euler-Maclaurin where angle = 0): the cost does not
/// grow with `last`. Exact to 1e-13 of the sum for angle = 0.
std::complex<double> tail_sum(int power, long first, long last, double step, double angle);

} // namespace bem_contact
