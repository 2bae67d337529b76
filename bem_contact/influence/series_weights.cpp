#include "bem_contact/influence/series_weights.hpp"

#include "bem_contact/influence/harmonics.hpp"
#include "bem_contact/influence/series_tail.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Array = Eigen::Array<double, 1, Eigen::Dynamic, Eigen::RowMajor>;

/// How far the series is summed beyond the last sample, as a multiple of its wavenumber. What is left is
/// 1/16^2 of a tail that is itself about 1 % of self at k_max a = 5; its mean is added in closed form.
constexpr double tail_reach = 16;

constexpr long block = 64; ///< harmonics whose cosines are found by rotation from one exact angle
constexpr std::size_t points = 6;

struct Interpolation {
  std::size_t first = 0, count = 0;
  std::array<double, points> weight{};

  bool operator==(const Interpolation& other) const { return first == other.first && count == other.count; }
};

/// g(k) from the samples: Lagrange on k g(k) in log k over the (up to) six samples around k, 0 left out.
class Interpolator {
public:
  explicit Interpolator(std::span<const double> wavenumber) : wavenumber_(wavenumber) {
    logarithm_.push_back(0); // of the sample k = 0: not used
    for (const double k : wavenumber.subspan(1))
      logarithm_.push_back(std::log(k));
  }

  /// `above`: index of the first sample beyond k.
  Interpolation at(double k, std::size_t above) const {
    const std::size_t positive = wavenumber_.size() - 1;
    Interpolation result;
    for (const std::size_t near : {above - 1, std::min(above, positive)})
      if (std::abs(wavenumber_[near] - k) <= 1e-10 * k) {
        result.first = near;
        result.count = 1;
        result.weight[0] = 1;
        return result;
      }
    result.count = std::min(points, positive);
    const std::size_t half = result.count / 2;
    result.first = std::clamp<std::size_t>(above > half ? above - half : 1, 1, positive - result.count + 1);
    const double log_k = std::log(k);
    for (std::size_t a = 0; a < result.count; ++a) {
      const double own = logarithm_[result.first + a];
      double above_line = wavenumber_[result.first + a], below_line = k;
      for (std::size_t b = 0; b < result.count; ++b)
        if (b != a) {
          above_line *= log_k - logarithm_[result.first + b];
          below_line *= own - logarithm_[result.first + b];
        }
      result.weight[a] = above_line / below_line;
    }
    return result;
  }

private:
  std::span<const double> wavenumber_;
  std::vector<double> logarithm_;
};

/// even(b, m) += sum over n of weight(b, n) cos(n m angle), odd with sin, for consecutive n.
void add_block(const RowMajor& weight, std::size_t first, std::size_t count, long n0, long harmonics,
               const Array& angle, const Array& turn_cos, const Array& turn_sin, RowMajor& even,
               RowMajor& odd) {
  const Array first_angle = static_cast<double>(n0) * angle;
  const Array first_cos = first_angle.cos(), first_sin = first_angle.sin();
  const auto from = static_cast<Eigen::Index>(first);
  add_harmonics(weight.data(), count, static_cast<std::size_t>(weight.cols()),
                static_cast<std::size_t>(harmonics), first_cos.data(), first_sin.data(), turn_cos.data(),
                turn_sin.data(), static_cast<std::size_t>(angle.size()), even.row(from).data(),
                odd.row(from).data());
}

} // namespace

SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets) {
  const auto nk = static_cast<Eigen::Index>(wavenumber.size());
  const double a = dx / 2, step = std::numbers::pi / half_period;
  RowMajor even = RowMajor::Zero(nk, offsets), odd = RowMajor::Zero(nk, offsets);
  even.row(0).setConstant(a / half_period);

  const Array angle = step * dx * Array::LinSpaced(offsets, 0, offsets - 1);
  const Array turn_cos = angle.cos(), turn_sin = angle.sin();
  const Interpolator interpolator(wavenumber);
  const double last = wavenumber.back(), before = wavenumber[wavenumber.size() - 2];
  const auto inside = static_cast<long>(std::floor(last / step * (1 + 1e-12)));
  RowMajor weight(static_cast<Eigen::Index>(points), block);
  Interpolation current;
  long start = 1, held = 0; // harmonics start .. start + held - 1 wait for the product
  std::size_t above = 1;
  for (long n = 1; n <= inside; ++n) {
    const double k = static_cast<double>(n) * step, s = std::sin(k * a);
    while (above < wavenumber.size() && wavenumber[above] <= k)
      ++above;
    const Interpolation g = interpolator.at(k, above);
    if (held == block || (held > 0 && !(g == current))) {
      add_block(weight, current.first, current.count, start, held, angle, turn_cos, turn_sin, even, odd);
      held = 0;
    }
    if (held == 0)
      start = n;
    current = g;
    const double coefficient = 2 * s * s / (half_period * k * k * a);
    for (std::size_t b = 0; b < g.count; ++b)
      weight(static_cast<Eigen::Index>(b), held) = coefficient * g.weight[b];
    ++held;
  }
  if (held > 0)
    add_block(weight, current.first, current.count, start, held, angle, turn_cos, turn_sin, even, odd);

  // Tail: g = (c0 + c1/k)/k with c0 = (k2 f2 - k1 f1)/(k2 - k1), c1 = k1 k2 (f1 - f2)/(k2 - k1), f = k g.
  // 2 sin^2(ka) cos(kx) = cos(kx) - cos(k(x + 2a))/2 - cos(k(x - 2a))/2, and x is a multiple of 2a.
  const auto reach = std::max(inside + 1, static_cast<long>(tail_reach * last / step));
  std::vector<std::array<std::complex<double>, 2>> sums; // of e^(i k x) / k^3 and / k^4
  for (int m = 0; m <= offsets; ++m)
    sums.push_back({tail_sum(3, inside + 1, reach, step, step * dx * m),
                    tail_sum(4, inside + 1, reach, step, step * dx * m)});
  const double end = (static_cast<double>(reach) + 0.5) * step, gap = last - before;
  for (int m = 0; m < offsets; ++m) {
    std::array<std::complex<double>, 2> sum;
    for (std::size_t p = 0; p < 2; ++p) {
      const std::complex<double> left =
          m > 0 ? sums[static_cast<std::size_t>(m - 1)][p] : std::conj(sums[1][p]);
      sum[p] =
          (sums[static_cast<std::size_t>(m)][p] - 0.5 * (left + sums[static_cast<std::size_t>(m + 1)][p])) /
          (half_period * a);
    }
    // The mean of sin^2(ka) cos(2kam) is 1/2, -1/4 and 0 at m = 0, 1 and more; sines have none.
    if (m < 2) {
      const double mean = (m == 0 ? 0.5 : -0.25) * 2 / (half_period * a) / step;
      sum[0] += mean / (2 * end * end);
      sum[1] += mean / (3 * end * end * end);
    }
    const std::complex<double> c0 = sum[0] / gap, c1 = before * last * sum[1] / gap;
    const std::complex<double> on_last = last * (last * c0 - c1), on_before = before * (c1 - before * c0);
    even(nk - 1, m) += on_last.real();
    even(nk - 2, m) += on_before.real();
    odd(nk - 1, m) += on_last.imag();
    odd(nk - 2, m) += on_before.imag();
  }

  SeriesWeights w{std::vector<double>(static_cast<std::size_t>(nk * offsets)),
                  std::vector<double>(static_cast<std::size_t>(nk * offsets))};
  Eigen::Map<RowMajor>(w.even.data(), offsets, nk) = even.transpose();
  Eigen::Map<RowMajor>(w.odd.data(), offsets, nk) = odd.transpose();
  return w;
}

} // namespace bem_contact
