#include "bem_contact/influence/series_tail.hpp"

#include "bem_contact/influence/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace bem_contact {
namespace {

using Complex = std::complex<double>;
constexpr int most_terms = 64; ///< of an expansion: room for them, and a bound

/// Sum over n >= start of n^-power: Euler-Maclaurin, next term below 1e-16 for start >= 64.
double infinite_sum(int power, double start) {
  const double p = power, f = std::pow(start, -p), x = 1 / start;
  return f * (start / (p - 1) + 0.5 + p * x / 12 - p * (p + 1) * (p + 2) * x * x * x / 720);
}

/// Sum over n >= start of n^-power z^n, z = e^(i angle): with n = start + j and (1 + j/start)^-power as its
/// binomial series it is z^start start^-power times the sum over l of C(-power, l) start^-l sum_j j^l z^j.
/// With u = 1/(1 - z), (z d/dz) u = u^2 - u, so sum_j j^l z^j is a polynomial in u. The series is asymptotic:
/// it is used to its smallest term.
Complex infinite_sum(int power, double start, double angle) {
  const Complex z = std::polar(1.0, angle), u = 1.0 / (1.0 - z);
  std::array<double, most_terms + 2> polynomial{0, 1}; // coefficients of u^0, u^1, ...
  double factor = 1;                                   // C(-power, l) start^-l
  Complex sum = 0;
  double smallest = std::numeric_limits<double>::infinity(), before = smallest;
  for (int l = 0; l < most_terms; ++l) {
    Complex value = 0;
    for (int d = l + 1; d >= 0; --d)
      value = value * u + polynomial[static_cast<std::size_t>(d)];
    const Complex term = factor * value;
    const double size = std::max(std::abs(term), before); // of two terms: every other one may vanish
    if (l > 1 && size > smallest)
      break;
    smallest = size;
    before = std::abs(term);
    sum += term;
    if (size < expansion_tolerance * std::abs(sum))
      break;
    for (int d = l + 2; d > 0; --d) { // from the highest, so that it can stay in its place
      const auto at = static_cast<std::size_t>(d);
      polynomial[at] = (d - 1) * polynomial[at - 1] - d * polynomial[at];
    }
    factor *= -(power + l) / ((l + 1) * start);
  }
  return sum * std::pow(start, -power) * std::polar(1.0, std::fmod(start * angle, 2 * std::numbers::pi));
}

} // namespace

std::complex<double> tail_sum(int power, long first, long last, double step, double angle) {
  const double from = angle > 0 ? std::ceil(expansion_phase / angle) : expansion_start;
  const long middle = std::clamp(from < 1e15 ? static_cast<long>(from) : last + 1, first, last + 1);
  Complex sum = 0, phase = 0;
  const Complex turn = std::polar(1.0, angle);
  for (long n = first; n < middle; ++n) {
    const auto x = static_cast<double>(n);
    phase = (n - first) % rotated_harmonics == 0 ? std::polar(1.0, x * angle) : phase * turn;
    double inverse = 1;
    for (int p = 0; p < power; ++p)
      inverse /= x;
    sum += inverse * phase;
  }
  if (middle <= last) {
    const auto begin = static_cast<double>(middle), end = static_cast<double>(last + 1);
    sum += angle > 0 ? infinite_sum(power, begin, angle) - infinite_sum(power, end, angle)
                     : infinite_sum(power, begin) - infinite_sum(power, end);
  }
  return sum * std::pow(step, -power);
}

} // namespace bem_contact
