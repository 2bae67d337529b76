#include "bem_contact/influence/series_weights.hpp"

#include "bem_contact/base/simd.hpp"
#include "bem_contact/influence/dense.hpp"
#include "bem_contact/influence/series_tail.hpp"
#include "bem_contact/influence/settings.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace bem_contact {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;

/// Cosines and sines one angle further.
BEM_CONTACT_WIDE void rotate(Index points, const double* __restrict cosine, const double* __restrict sine,
                             const double* __restrict turn_cos, const double* __restrict turn_sin,
                             double* __restrict next_cosine, double* __restrict next_sine) {
  for (Index p = 0; p < points; ++p) {
    next_cosine[p] = cosine[p] * turn_cos[p] - sine[p] * turn_sin[p];
    next_sine[p] = sine[p] * turn_cos[p] + cosine[p] * turn_sin[p];
  }
}

/// What the samples count for, as it is added up: even(m, k) and odd(m, k), m the offset.
class Sums {
public:
  Sums(const SeriesPoints& points, double dx, int offsets)
      : wavenumber_(points.wavenumber()), half_period_(points.half_period()), dx_(dx), offsets_(offsets),
        even_(MatrixXd::Zero(offsets, static_cast<Index>(wavenumber_.size()))), odd_(even_) {
    even_.col(0).setConstant(dx / 2 / half_period_);
  }

  void add(const SeriesPoints::Run& run);
  void add_tail(const TailSeries& tail);
  SeriesWeights result() const;

private:
  double step() const { return std::numbers::pi / half_period_; }

  std::span<const double> wavenumber_;
  double half_period_, dx_;
  int offsets_;
  MatrixXd even_, odd_;
  MatrixXd cosine_, sine_, product_; ///< of one run
};

/// Adds what the points count for times 2 sin^2(k a) / (L k^2 a) cos(k x) and sin(k x).
void Sums::add(const SeriesPoints::Run& run) {
  const auto points = static_cast<Index>(run.k.size());
  const Eigen::Map<const ArrayXd> k(run.k.data(), points);
  const Eigen::Map<const MatrixXd> counts(run.weight.data(), points,
                                          static_cast<Index>(run.weight.size()) / points);
  const ArrayXd half = (dx_ / 2) * k, half_sin = half.sin(), half_cos = half.cos();
  const ArrayXd turn_cos = 1 - 2 * half_sin.square(), turn_sin = 2 * half_sin * half_cos;
  const ArrayXd coefficient = half_sin.square() * (4 / (half_period_ * dx_)) / k.square();
  cosine_.resize(points, offsets_);
  sine_.resize(points, offsets_);
  for (Index m = 0; m < offsets_; ++m)
    if (m % rotated_offsets == 0) {
      cosine_.col(m) = (static_cast<double>(2 * m) * half).cos();
      sine_.col(m) = (static_cast<double>(2 * m) * half).sin();
    } else
      rotate(points, &cosine_(0, m - 1), &sine_(0, m - 1), turn_cos.data(), turn_sin.data(), &cosine_(0, m),
             &sine_(0, m));
  const MatrixXd weight = coefficient.matrix().asDiagonal() * counts;
  product_.resize(offsets_, weight.cols());
  for (const auto& [wave, sum] : {std::pair(&cosine_, &even_), std::pair(&sine_, &odd_)}) {
    dense_product_of_columns(*wave, weight, product_.data());
    sum->middleCols(static_cast<Index>(run.first), weight.cols()) += product_;
  }
}

/// Harmonics beyond the last sample, where g = (c0 + c1/k)/k with c0 = (k2 f2 - k1 f1)/(k2 - k1),
/// c1 = k1 k2 (f1 - f2)/(k2 - k1) and f = k g at the last two samples k1 and k2.
void Sums::add_tail(const TailSeries& tail) {
  const double a = dx_ / 2, last = wavenumber_.back(), before = wavenumber_[wavenumber_.size() - 2];
  const Index nk = even_.cols();
  // 2 sin^2(ka) cos(kx) = cos(kx) - cos(k(x + 2a))/2 - cos(k(x - 2a))/2, and x is a multiple of 2a.
  std::vector<std::array<std::complex<double>, 2>> sums; // of e^(i k x) / k^3 and / k^4
  for (int m = 0; m <= offsets_; ++m) {
    const TailSums at_offset = tail.at(step() * dx_ * m);
    sums.push_back({at_offset.cubes, at_offset.fourths});
  }
  const double end = (static_cast<double>(tail.last()) + 0.5) * step(), gap = last - before;
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
    even_(m, nk - 1) += on_last.real();
    even_(m, nk - 2) += on_before.real();
    odd_(m, nk - 1) += on_last.imag();
    odd_(m, nk - 2) += on_before.imag();
  }
}

SeriesWeights Sums::result() const {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  SeriesWeights w{std::vector<double>(static_cast<std::size_t>(even_.size())),
                  std::vector<double>(static_cast<std::size_t>(odd_.size()))};
  Eigen::Map<RowMajor>(w.even.data(), even_.rows(), even_.cols()) = even_;
  Eigen::Map<RowMajor>(w.odd.data(), odd_.rows(), odd_.cols()) = odd_;
  return w;
}

} // namespace

SeriesWeights series_weights(const SeriesPoints& points, double dx, int offsets) {
  Sums sums(points, dx, offsets);
  for (const SeriesPoints::Run& run : points.runs())
    sums.add(run);
  sums.add_tail(points.tail());
  return sums.result();
}

SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets) {
  const double angle = std::numbers::pi / half_period * dx * offsets;
  return series_weights(SeriesPoints(wavenumber, half_period, angle), dx, offsets);
}

} // namespace bem_contact
