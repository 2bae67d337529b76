#include "bem_contact/influence/series_weights.hpp"

#include "bem_contact/influence/series_tail.hpp"
#include "bem_contact/influence/settings.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace bem_contact {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;

/// Sum over `count` equally spaced points from -1 to 1 of each even Chebyshev polynomial T_0, T_2, ...; the
/// odd ones have none.
ArrayXd even_moments(Index count, Index polynomials) {
  const Index half = count / 2; // the other half is the same, for T_2j(t) = T_j(2 t^2 - 1)
  const ArrayXd t = ArrayXd::LinSpaced(count, -1, 1).head(half);
  const ArrayXd argument = 2 * t.square() - 1;
  const double middle = count % 2; // where the argument is -1
  ArrayXd moments(polynomials), before = ArrayXd::Ones(half), now = argument;
  for (Index j = 0; j < polynomials; ++j) {
    moments[j] = 2 * before.sum() + (j % 2 == 0 ? middle : -middle);
    before = 2 * argument * now - before;
    before.swap(now);
  }
  return moments;
}

} // namespace

HarmonicPoints harmonic_points(long first, long last, double largest_angle) {
  const Index count = last - first + 1;
  const double waves = 0.5 * static_cast<double>(count - 1) * largest_angle;
  const auto points = static_cast<Index>(std::ceil(waves + point_reserve * std::cbrt(waves)) + least_points);
  if (points >= count)
    return {ArrayXd::LinSpaced(count, static_cast<double>(first), static_cast<double>(last)),
            ArrayXd::Ones(count)};
  const ArrayXd angle = (ArrayXd::LinSpaced(points, 0, static_cast<double>(points - 1)) + 0.5) *
                        (std::numbers::pi / static_cast<double>(points));
  const ArrayXd moments = even_moments(count, (points + 1) / 2);
  const ArrayXd node = angle.cos(), argument = 2 * node.square() - 1;
  ArrayXd weight = ArrayXd::Constant(points, moments[0]), before = ArrayXd::Ones(points), now = argument;
  for (Index j = 1; j < moments.size(); ++j) { // now: T_2j of the nodes
    weight += 2 * moments[j] * now;
    before = 2 * argument * now - before;
    before.swap(now);
  }
  const double half = 0.5 * static_cast<double>(last - first), middle = static_cast<double>(first) + half;
  return {middle + half * node, weight / static_cast<double>(points)};
}

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr std::size_t points = 6; ///< of the interpolation between samples

struct Interpolation {
  std::size_t first = 0, count = 0;
  std::array<double, points> weight{};
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

/// What the samples count for, as it is added up: even[k][m] and odd[k][m], m the offset.
class Sums {
public:
  Sums(std::span<const double> wavenumber, double half_period, double dx, int offsets)
      : wavenumber_(wavenumber), half_period_(half_period), dx_(dx), offsets_(offsets),
        even_(RowMajor::Zero(static_cast<Eigen::Index>(wavenumber.size()), offsets)), odd_(even_) {
    even_.row(0).setConstant(dx / 2 / half_period);
  }

  void add_up_to_last_sample();
  void add_tail();
  SeriesWeights result() const;

private:
  double step() const { return std::numbers::pi / half_period_; }
  /// The last harmonic that is not beyond the last sample.
  long inside() const {
    return static_cast<long>(std::floor(wavenumber_.back() / step() * (1 + last_sample_slack)));
  }
  /// 2 sin^2(ka) / (L k^2 a)
  Eigen::ArrayXd coefficient(const Eigen::ArrayXd& k) const {
    return (k * (dx_ / 2)).sin().square() * (4 / (half_period_ * dx_)) / k.square();
  }
  void add_points(const Eigen::ArrayXd& k, const RowMajor& weight, std::size_t first_sample);
  void add_between(const Interpolator& interpolator, long first, long last, std::size_t above);

  std::span<const double> wavenumber_;
  double half_period_, dx_;
  int offsets_;
  RowMajor even_, odd_;
};

/// Adds weight[b][p] cos(k_p x) and sin(k_p x) to the samples first_sample + b.
void Sums::add_points(const Eigen::ArrayXd& k, const RowMajor& weight, std::size_t first_sample) {
  const Eigen::ArrayXd angle = k * dx_, turn_cos = angle.cos(), turn_sin = angle.sin();
  Eigen::MatrixXd cosine(k.size(), offsets_), sine(k.size(), offsets_);
  for (Eigen::Index m = 0; m < offsets_; ++m)
    if (m % rotated_offsets == 0) {
      cosine.col(m) = (static_cast<double>(m) * angle).cos();
      sine.col(m) = (static_cast<double>(m) * angle).sin();
    } else {
      const auto c = cosine.col(m - 1).array(), s = sine.col(m - 1).array();
      cosine.col(m) = c * turn_cos - s * turn_sin;
      sine.col(m) = s * turn_cos + c * turn_sin;
    }
  const auto from = static_cast<Eigen::Index>(first_sample);
  even_.middleRows(from, weight.rows()).noalias() += weight * cosine;
  odd_.middleRows(from, weight.rows()).noalias() += weight * sine;
}

/// Harmonics between two samples, `above` the upper one.
void Sums::add_between(const Interpolator& interpolator, long first, long last, std::size_t above) {
  const HarmonicPoints points_between = harmonic_points(first, last, step() * dx_ * offsets_);
  const Eigen::ArrayXd k = step() * points_between.position;
  const Eigen::ArrayXd coefficients = coefficient(k) * points_between.weight;
  Interpolation samples = interpolator.at(k[0], above);
  RowMajor weight(static_cast<Eigen::Index>(samples.count), k.size());
  for (Eigen::Index p = 0; p < k.size(); ++p) {
    samples = interpolator.at(k[p], above);
    for (std::size_t b = 0; b < samples.count; ++b)
      weight(static_cast<Eigen::Index>(b), p) = coefficients[p] * samples.weight[b];
  }
  add_points(k, weight, samples.first);
}

/// A harmonic that is a sample counts for itself, those between two samples by interpolation.
void Sums::add_up_to_last_sample() {
  const Interpolator interpolator(wavenumber_);
  long next = 1; // harmonic
  for (std::size_t above = 1; above < wavenumber_.size(); ++above) {
    const double sample = wavenumber_[above] / step();
    const long nearest = std::lround(sample);
    const bool is_sample = std::abs(static_cast<double>(nearest) - sample) <= sample_snap * sample;
    const long last = is_sample ? nearest - 1 : static_cast<long>(std::floor(sample));
    if (last >= next)
      add_between(interpolator, next, last, above);
    if (is_sample) {
      const Eigen::ArrayXd k = Eigen::ArrayXd::Constant(1, step() * static_cast<double>(nearest));
      add_points(k, coefficient(k).matrix(), above);
    }
    next = std::max(next, (is_sample ? nearest : last) + 1);
  }
}

/// Harmonics beyond the last sample, where g = (c0 + c1/k)/k with c0 = (k2 f2 - k1 f1)/(k2 - k1),
/// c1 = k1 k2 (f1 - f2)/(k2 - k1) and f = k g at the last two samples k1 and k2.
void Sums::add_tail() {
  const double a = dx_ / 2, last = wavenumber_.back(), before = wavenumber_[wavenumber_.size() - 2];
  const Eigen::Index nk = even_.rows();
  // 2 sin^2(ka) cos(kx) = cos(kx) - cos(k(x + 2a))/2 - cos(k(x - 2a))/2, and x is a multiple of 2a.
  const auto reach = std::max(inside() + 1, static_cast<long>(tail_reach * last / step()));
  std::vector<std::array<std::complex<double>, 2>> sums; // of e^(i k x) / k^3 and / k^4
  for (int m = 0; m <= offsets_; ++m)
    sums.push_back({tail_sum(3, inside() + 1, reach, step(), step() * dx_ * m),
                    tail_sum(4, inside() + 1, reach, step(), step() * dx_ * m)});
  const double end = (static_cast<double>(reach) + 0.5) * step(), gap = last - before;
  for (int m = 0; m < offsets_; ++m) {
    std::array<std::complex<double>, 2> sum;
    for (std::size_t p = 0; p < 2; ++p) {
      const std::complex<double> left =
          m > 0 ? sums[static_cast<std::size_t>(m - 1)][p] : std::conj(sums[1][p]);
      sum[p] =
          (sums[static_cast<std::size_t>(m)][p] - 0.5 * (left + sums[static_cast<std::size_t>(m + 1)][p])) /
          (half_period_ * a);
    }
    // The mean of sin^2(ka) cos(2kam) is 1/2, -1/4 and 0 at m = 0, 1 and more; sines have none.
    if (m < 2) {
      const double mean = (m == 0 ? 0.5 : -0.25) * 2 / (half_period_ * a) / step();
      sum[0] += mean / (2 * end * end);
      sum[1] += mean / (3 * end * end * end);
    }
    const std::complex<double> c0 = sum[0] / gap, c1 = before * last * sum[1] / gap;
    const std::complex<double> on_last = last * (last * c0 - c1), on_before = before * (c1 - before * c0);
    even_(nk - 1, m) += on_last.real();
    even_(nk - 2, m) += on_before.real();
    odd_(nk - 1, m) += on_last.imag();
    odd_(nk - 2, m) += on_before.imag();
  }
}

SeriesWeights Sums::result() const {
  SeriesWeights w{std::vector<double>(static_cast<std::size_t>(even_.size())),
                  std::vector<double>(static_cast<std::size_t>(odd_.size()))};
  Eigen::Map<RowMajor>(w.even.data(), even_.cols(), even_.rows()) = even_.transpose();
  Eigen::Map<RowMajor>(w.odd.data(), odd_.cols(), odd_.rows()) = odd_.transpose();
  return w;
}

} // namespace

SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets) {
  Sums sums(wavenumber, half_period, dx, offsets);
  sums.add_up_to_last_sample();
  sums.add_tail();
  return sums.result();
}

} // namespace bem_contact
