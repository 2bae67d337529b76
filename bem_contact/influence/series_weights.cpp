#include "bem_contact/influence/series_weights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact {
namespace {

/// How far the series is summed beyond the last sample, as a multiple of its wavenumber. What is left is
/// 1/16^2 of a tail that is itself about 1 % of self at k_max a = 5; its mean is added in closed form.
constexpr double tail_reach = 16;

struct Interpolation {
  std::size_t first = 0, count = 0;
  std::array<double, 6> weight{};
};

/// g(k) from the samples: Lagrange on k g(k) in log k over the (up to) six samples around k, 0 left out.
Interpolation interpolate(std::span<const double> wavenumber, double k) {
  const std::size_t positive = wavenumber.size() - 1;
  Interpolation result;
  const auto above = static_cast<std::size_t>(std::upper_bound(wavenumber.begin(), wavenumber.end(), k) -
                                              wavenumber.begin());
  for (const std::size_t near : {above - 1, std::min(above, positive)})
    if (std::abs(wavenumber[near] - k) <= 1e-10 * k) {
      result.first = near;
      result.count = 1;
      result.weight[0] = 1;
      return result;
    }
  result.count = std::min<std::size_t>(6, positive);
  const std::size_t half = result.count / 2;
  result.first = std::clamp<std::size_t>(above > half ? above - half : 1, 1, positive - result.count + 1);
  for (std::size_t a = 0; a < result.count; ++a) {
    double w = wavenumber[result.first + a] / k;
    for (std::size_t b = 0; b < result.count; ++b)
      if (b != a)
        w *= std::log(k / wavenumber[result.first + b]) /
             std::log(wavenumber[result.first + a] / wavenumber[result.first + b]);
    result.weight[a] = w;
  }
  return result;
}

/// cos(m theta) and sin(m theta), m = 0 .. size-1, by rotation.
void harmonics(double theta, std::vector<double>& cosine, std::vector<double>& sine) {
  const double c = std::cos(theta), s = std::sin(theta);
  cosine[0] = 1;
  sine[0] = 0;
  for (std::size_t m = 1; m < cosine.size(); ++m) {
    cosine[m] = c * cosine[m - 1] - s * sine[m - 1];
    sine[m] = s * cosine[m - 1] + c * sine[m - 1];
  }
}

} // namespace

SeriesWeights series_weights(std::span<const double> wavenumber, double half_period, double dx, int offsets) {
  const std::size_t nk = wavenumber.size(), nm = static_cast<std::size_t>(offsets);
  const double a = dx / 2, step = std::numbers::pi / half_period;
  SeriesWeights w{std::vector<double>(nm * nk), std::vector<double>(nm * nk)};
  std::vector<double> cosine(nm), sine(nm);

  for (std::size_t m = 0; m < nm; ++m)
    w.even[m * nk] = a / half_period;
  const auto coefficient = [&](double k) {
    const double s = std::sin(k * a);
    return 2 * s * s / (half_period * k * k * a);
  };
  const double last = wavenumber.back(), before = wavenumber[nk - 2];
  const auto inside = static_cast<long>(std::floor(last / step * (1 + 1e-12)));
  for (long n = 1; n <= inside; ++n) {
    const double k = static_cast<double>(n) * step;
    const Interpolation g = interpolate(wavenumber, k);
    harmonics(k * dx, cosine, sine);
    const double c = coefficient(k);
    for (std::size_t m = 0; m < nm; ++m)
      for (std::size_t b = 0; b < g.count; ++b) {
        w.even[m * nk + g.first + b] += c * g.weight[b] * cosine[m];
        w.odd[m * nk + g.first + b] += c * g.weight[b] * sine[m];
      }
  }

  // Tail: g = (c0 + c1/k)/k with c0 = (k2 f2 - k1 f1)/(k2 - k1), c1 = k1 k2 (f1 - f2)/(k2 - k1), f = k g.
  std::array<std::vector<double>, 2> even, odd; // sums of c/k and of c/k^2
  for (auto* table : {&even, &odd})
    table->fill(std::vector<double>(nm));
  const auto reach = std::max(inside + 1, static_cast<long>(tail_reach * last / step));
  for (long n = inside + 1; n <= reach; ++n) {
    const double k = static_cast<double>(n) * step, c = coefficient(k) / k;
    harmonics(k * dx, cosine, sine);
    for (std::size_t m = 0; m < nm; ++m) {
      even[0][m] += c * cosine[m];
      odd[0][m] += c * sine[m];
      even[1][m] += c / k * cosine[m];
      odd[1][m] += c / k * sine[m];
    }
  }
  // The mean of sin^2(ka) cos(2kam) is 1/2, -1/4 and 0 at m = 0, 1 and more; sines have none.
  const double end = (static_cast<double>(reach) + 0.5) * step;
  for (std::size_t m = 0; m < std::min<std::size_t>(nm, 2); ++m) {
    const double mean = (m == 0 ? 0.5 : -0.25) * 2 / (half_period * a) / step;
    even[0][m] += mean / (2 * end * end);
    even[1][m] += mean / (3 * end * end * end);
  }
  const double gap = last - before;
  for (std::size_t m = 0; m < nm; ++m)
    for (auto [to, sum] : {std::pair{&w.even, &even}, std::pair{&w.odd, &odd}}) {
      const double c0 = (*sum)[0][m] / gap, c1 = before * last * (*sum)[1][m] / gap;
      (*to)[m * nk + nk - 1] += last * (last * c0 - c1);
      (*to)[m * nk + nk - 2] += before * (c1 - before * c0);
    }
  return w;
}

} // namespace bem_contact
