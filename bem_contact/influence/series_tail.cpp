#include "bem_contact/influence/series_tail.hpp"

#include "bem_contact/influence/harmonic_points.hpp"
#include "bem_contact/influence/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace bem_contact {
namespace {

using Complex = std::complex<double>;
/// 1 (harmonics). and without a phase from this harmonic on (Euler-Maclaurin: next term below 1e-16).
constexpr double expansion_start = 64.0;

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

TailSeries::TailSeries(long first, long last, double step) : first_(first), last_(last), step_(step) {
  for (long from = first; from <= last && std::ssize(octaves_) < tail_octaves; from = octaves_.back().end) {
    const long end = std::min(2 * from, last + 1);
    const HarmonicPoints points = harmonic_points(
        from, end - 1, std::min(expansion_phase / static_cast<double>(from), std::numbers::pi));
    Octave octave{end, points.position, {}, {}};
    for (std::size_t p = 0; p < points.weight.size(); ++p) {
      octave.cube.push_back(points.weight[p] / std::pow(points.position[p], 3));
      octave.fourth.push_back(octave.cube[p] / points.position[p]);
    }
    octaves_.push_back(std::move(octave));
  }
}

TailSums TailSeries::at(double angle) const {
  const auto needs_terms = [&](long n) {
    const auto x = static_cast<double>(n);
    return n <= last_ && (angle > 0 ? x * angle < expansion_phase : x < expansion_start);
  };
  TailSums sums;
  long n = first_;
  for (const Octave& octave : octaves_) {
    if (!needs_terms(n))
      break;
    for (std::size_t p = 0; p < octave.position.size(); ++p) {
      const Complex wave = std::polar(1.0, octave.position[p] * angle);
      sums.cubes += octave.cube[p] * wave;
      sums.fourths += octave.fourth[p] * wave;
    }
    n = octave.end;
  }
  for (; needs_terms(n); ++n) {
    const auto x = static_cast<double>(n);
    const Complex term = std::polar(1 / (x * x * x), x * angle);
    sums.cubes += term;
    sums.fourths += term / x;
  }
  if (n <= last_) {
    const TailSums rest = sums_of_rest(static_cast<double>(n), static_cast<double>(last_ + 1), angle);
    sums.cubes += rest.cubes;
    sums.fourths += rest.fourths;
  }
  const double cube = step_ * step_ * step_;
  return {sums.cubes / cube, sums.fourths / (cube * step_)};
}

} // namespace bem_contact
