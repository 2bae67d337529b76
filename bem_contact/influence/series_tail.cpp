#include "bem_contact/influence/series_tail.hpp"

#include "bem_contact/influence/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

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
/// The series is asymptotic: it is used to its smallest term.
class InfiniteSum {
public:
  InfiniteSum(int power, double start) : power_(power), start_(start) {}

  /// Takes sum_j j^l z^j of the next l. False at the end.
  bool take(int l, Complex value) {
    if (ended_)
      return false;
    const Complex term = factor_ * value;
    const double size = std::max(std::abs(term), before_); // of two terms: every other one may vanish
    ended_ = l > 1 && size > smallest_;
    if (ended_)
      return false;
    smallest_ = size;
    before_ = std::abs(term);
    sum_ += term;
    factor_ *= -(power_ + l) / ((l + 1) * start_);
    ended_ = size < expansion_tolerance * std::abs(sum_);
    return !ended_;
  }
  Complex value(double angle) const {
    return sum_ * std::pow(start_, -power_) *
           std::polar(1.0, std::fmod(start_ * angle, 2 * std::numbers::pi));
  }

private:
  int power_;
  double start_, factor_ = 1; ///< C(-power, l) start^-l
  Complex sum_ = 0;
  double smallest_ = std::numeric_limits<double>::infinity(), before_ = smallest_;
  bool ended_ = false;
};

/// Hands sum_j j^l z^j to all of them, l = 0, 1, ... With u = 1/(1 - z), (z d/dz) u = u^2 - u, so it is a
/// polynomial in u.
void add_terms(double angle, std::span<InfiniteSum> sums) {
  const Complex u = 1.0 / (1.0 - std::polar(1.0, angle));
  std::array<double, most_terms + 2> polynomial{0, 1}; // coefficients of u^0, u^1, ...
  for (int l = 0; l < most_terms; ++l) {
    Complex value = 0;
    for (int d = l + 1; d >= 0; --d)
      value = value * u + polynomial[static_cast<std::size_t>(d)];
    bool more = false;
    for (InfiniteSum& sum : sums)
      more = sum.take(l, value) || more;
    if (!more)
      break;
    for (int d = l + 2; d > 0; --d) { // from the highest, so that it can stay in its place
      const auto at = static_cast<std::size_t>(d);
      polynomial[at] = (d - 1) * polynomial[at - 1] - d * polynomial[at];
    }
  }
}

/// Sums over n = first .. last, both of which are large.
TailSums sums_of_rest(double first, double end, double angle) {
  if (angle == 0)
    return {infinite_sum(3, first) - infinite_sum(3, end), infinite_sum(4, first) - infinite_sum(4, end)};
  std::array sums{InfiniteSum(3, first), InfiniteSum(3, end), InfiniteSum(4, first), InfiniteSum(4, end)};
  add_terms(angle, sums);
  return {sums[0].value(angle) - sums[1].value(angle), sums[2].value(angle) - sums[3].value(angle)};
}

} // namespace

TailSums tail_sums(long first, long last, double step, double angle) {
  const double from = angle > 0 ? std::ceil(expansion_phase / angle) : expansion_start;
  const long middle = std::clamp(from < 1e15 ? static_cast<long>(from) : last + 1, first, last + 1);
  TailSums sums;
  Complex phase = 0;
  const Complex turn = std::polar(1.0, angle);
  for (long n = first; n < middle; ++n) {
    const auto x = static_cast<double>(n);
    phase = (n - first) % rotated_harmonics == 0 ? std::polar(1.0, x * angle) : phase * turn;
    const Complex term = phase / (x * x * x);
    sums.cubes += term;
    sums.fourths += term / x;
  }
  if (middle <= last) {
    const TailSums rest = sums_of_rest(static_cast<double>(middle), static_cast<double>(last + 1), angle);
    sums.cubes += rest.cubes;
    sums.fourths += rest.fourths;
  }
  const double cube = step * step * step;
  return {sums.cubes / cube, sums.fourths / (cube * step)};
}

} // namespace bem_contact
