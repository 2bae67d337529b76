#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

/// Searches in a bracket, written once for this room. They end at a given width, because the functions below
/// cost little and their rounding is far below those widths.
namespace bem_contact {

/// Where `test` changes: true at `holds`, false at `fails` (on either side of it). Both ends after
/// `halvings`.
template <class Test>
std::pair<double, double> bisect(double holds, double fails, int halvings, const Test& test) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (holds + fails);
    (test(middle) ? holds : fails) = middle;
  }
  return {holds, fails};
}

struct Minimum {
  double at = 0;    ///< middle of the last bracket
  double value = 0; ///< the least that was met near it
};

/// The minimum of f in [a, b] by golden section, to `width`.
template <class Function> Minimum golden_section(double a, double b, double width, const Function& f) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1);
  double c = b - golden * (b - a), d = a + golden * (b - a), fc = f(c), fd = f(d);
  while (b - a > width) {
    if (fc < fd) {
      b = d, d = c, fd = fc;
      c = b - golden * (b - a), fc = f(c);
    } else {
      a = c, c = d, fc = fd;
      d = a + golden * (b - a), fd = f(d);
    }
  }
  return {0.5 * (a + b), std::min(fc, fd)};
}

} // namespace bem_contact
