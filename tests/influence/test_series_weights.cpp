// The weights of the Fourier series against the series itself, added up term by term.
#include "bem_contact/influence/harmonic_points.hpp"
#include "bem_contact/influence/series_tail.hpp"
#include "bem_contact/influence/series_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

using namespace bem_contact;

namespace {

std::vector<double> samples(double half_period, double largest, int per_decade) {
  std::vector<double> k;
  for (int n = 0; n <= 8; ++n)
    k.push_back(n * std::numbers::pi / half_period);
  const double from = k.back();
  const int steps = static_cast<int>(std::ceil(std::log10(largest / from) * per_decade));
  for (int i = 1; i <= steps; ++i)
    k.push_back(from * std::pow(largest / from, i / static_cast<double>(steps)));
  return k;
}

/// g(k) at every harmonic from the samples `f` of k g(k), as series_weights.hpp says; summed as it says.
std::complex<double> direct(const std::vector<double>& wavenumber, const std::vector<double>& g,
                            double half_period, double dx, int m) {
  const double a = dx / 2, step = std::numbers::pi / half_period;
  const std::size_t nk = wavenumber.size();
  const double last = wavenumber.back(), before = wavenumber[nk - 2];
  const double f2 = last * g[nk - 1], f1 = before * g[nk - 2];
  const double c0 = (last * f2 - before * f1) / (last - before),
               c1 = before * last * (f1 - f2) / (last - before);
  const auto reach = static_cast<long>(16 * last / step);
  std::complex<double> sum = a / half_period * g[0];
  for (long n = 1; n <= reach; ++n) {
    const double k = static_cast<double>(n) * step;
    double value = (c0 + c1 / k) / k;
    if (k <= last * (1 + 1e-12)) {
      const auto above = static_cast<std::size_t>(std::upper_bound(wavenumber.begin(), wavenumber.end(), k) -
                                                  wavenumber.begin());
      const std::size_t first = std::clamp<std::size_t>(above > 3 ? above - 3 : 1, 1, nk - 6);
      value = 0;
      for (std::size_t p = first; p < first + 6; ++p) {
        double w = wavenumber[p] / k;
        for (std::size_t q = first; q < first + 6; ++q)
          if (q != p)
            w *= std::log(k / wavenumber[q]) / std::log(wavenumber[p] / wavenumber[q]);
        value += w * g[p];
      }
    }
    const double s = std::sin(k * a);
    sum += 2 * s * s / (half_period * k * k * a) * value * std::polar(1.0, k * dx * m);
  }
  const double end = (static_cast<double>(reach) + 0.5) * step;
  if (m < 2)
    sum += (m == 0 ? 0.5 : -0.25) * 2 / (half_period * a) / step *
           (c0 / (2 * end * end) + c1 / (3 * end * end * end));
  return sum;
}

} // namespace

TEST(SeriesWeights, AreTheSeriesTermByTerm) {
  struct Case {
    double half_period, largest, dx;
    int offsets;
  };
  for (const Case c : {Case{120, 25, 0.4, 60}, Case{120, 25, 1.5, 80}, Case{300, 60, 0.17, 7}}) {
    const std::vector<double> k = samples(c.half_period, c.largest, 7);
    std::vector<double> g;
    for (const double q : k) // like a body's kernel: a logarithm at small k, 1/k at large
      g.push_back(std::log1p(3 / (q + 0.02)) + 0.2 * std::sin(q));
    const SeriesWeights w = series_weights(k, c.half_period, c.dx, c.offsets);
    const double self = direct(k, g, c.half_period, c.dx, 0).real();
    for (int m = 0; m < c.offsets; m += m < 6 ? 1 : 9) {
      double even = 0, odd = 0;
      for (std::size_t b = 0; b < k.size(); ++b) {
        even += w.even[static_cast<std::size_t>(m) * k.size() + b] * g[b];
        odd += w.odd[static_cast<std::size_t>(m) * k.size() + b] * g[b];
      }
      const std::complex<double> exact = direct(k, g, c.half_period, c.dx, m);
      EXPECT_NEAR(even, exact.real(), 2e-13 * self) << m;
      EXPECT_NEAR(odd, exact.imag(), 2e-13 * self) << m;
    }
  }
}

TEST(SeriesWeights, FewPointsStandForManyHarmonics) {
  for (const long first : {6000L, 17L})
    for (const long count : {1L, 2L, 1999L, 2000L}) {
      const long last = std::min(first + count - 1, first * 4 / 3);
      const double angle = 0.03;
      const HarmonicPoints points = harmonic_points(first, last, angle);
      for (const double turn : {0.0, 0.3 * angle, angle}) {
        std::complex<double> exact = 0, sum = 0;
        double size = 0;
        for (long n = first; n <= last; ++n) {
          exact += std::polar(std::log(double(n)) / double(n), double(n) * turn);
          size += std::log(double(n)) / double(n);
        }
        for (std::size_t p = 0; p < points.position.size(); ++p) {
          const double n = points.position[p];
          sum += points.weight[p] * std::polar(std::log(n) / n, n * turn);
        }
        EXPECT_LT(std::abs(sum - exact), 1e-13 * size) << first << ' ' << last << ' ' << turn;
      }
      EXPECT_LE(points.position.size(),
                static_cast<std::size_t>(last - first > 1000 ? 100 : last - first + 1));
    }
}

TEST(SeriesWeights, TailSumsAreTheSums) {
  for (const int power : {3, 4})
    for (const long first : {3L, 800L})
      for (const double angle : {0.0, 1e-3, 0.01, 0.3, 1.7, std::numbers::pi}) {
        const long last = 40 * first;
        std::complex<double> sum = 0;
        double size = 0;
        for (long n = last; n >= first; --n) {
          sum += std::polar(std::pow(0.01 * static_cast<double>(n), -power), static_cast<double>(n) * angle);
          size += std::pow(0.01 * static_cast<double>(n), -power);
        }
        const TailSums tail = TailSeries(first, last, 0.01).at(angle);
        EXPECT_LT(std::abs((power == 3 ? tail.cubes : tail.fourths) - sum), 1e-13 * size)
            << power << ' ' << first << ' ' << angle;
      }
}

/// Points that are kept serve other elements of the same file, with the same weights but for rounding.
TEST(SeriesWeights, KeptPointsServeOtherElements) {
  const std::vector<double> k = samples(120, 25, 7), other = samples(120, 30, 7);
  SeriesStore store;
  const SeriesPoints* first = nullptr;
  for (const double dx : {0.40, 0.41, 0.39}) {
    const int offsets = 60;
    const SeriesPoints& points = store.get(k, 120, std::numbers::pi / 120 * dx * offsets);
    first = first ? first : &points;
    EXPECT_EQ(first, &points) << dx;
    const SeriesWeights kept = series_weights(points, dx, offsets), own = series_weights(k, 120, dx, offsets);
    const double largest = *std::ranges::max_element(own.even);
    for (std::size_t i = 0; i < own.even.size(); ++i) {
      EXPECT_NEAR(kept.even[i], own.even[i], 1e-13 * largest);
      EXPECT_NEAR(kept.odd[i], own.odd[i], 1e-13 * largest);
    }
  }
  // Not those of another file, another period, or longer patches.
  EXPECT_EQ(store.get(other, 120, 0.62).wavenumber().back(), other.back());
  EXPECT_EQ(store.get(k, 130, 0.62).half_period(), 130);
  EXPECT_GE(store.get(k, 120, 1.9).largest_angle(), 1.9);
}
