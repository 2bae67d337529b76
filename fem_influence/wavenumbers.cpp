#include "fem_influence/wavenumbers.hpp"

#include "bem_contact/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bem_contact::fem {

std::vector<double> wavenumber_samples(double half_period, double shortest_dx, int samples_per_decade) {
  if (!(half_period > 0) || !(shortest_dx > 0) || samples_per_decade < 1)
    throw InputError("The wavenumbers cannot be chosen",
                     "half_period, shortest_dx and samples_per_decade must be positive",
                     "correct [harmonic] of the body file");
  const double unit = std::numbers::pi / half_period, largest = 10 / shortest_dx;
  std::vector<double> k{0};
  for (int n = 1; n <= exact_harmonics; ++n)
    k.push_back(n * unit);
  if (largest <= k.back())
    throw InputError("The largest wavenumber 10 / shortest_dx does not exceed that of harmonic 8",
                     "the half period is too short for elements that long",
                     "lower harmonic.shortest_dx or raise harmonic.half_period");
  const double from = std::log(k.back()), length = std::log(largest) - from;
  const auto steps = static_cast<int>(std::ceil(length / std::numbers::ln10 * samples_per_decade));
  for (int i = 1; i < steps; ++i)
    k.push_back(std::exp(from + length * i / steps));
  k.push_back(largest);
  return k;
}

double interpolation_error(std::span<const double> wavenumber, std::span<const double> kernel,
                           std::size_t size, int probes) {
  const std::size_t first = exact_harmonics, count = wavenumber.size();
  if (count < first + 7)
    return -1;
  const std::size_t entries = size * size;
  const auto at = [&](std::size_t k, std::size_t e) { return kernel[k * entries + e]; };
  double error = 0;
  const std::size_t from = first + 3, to = count - 4; // both may be left out
  for (int p = 0; p < probes; ++p) {
    const std::size_t k =
        from + (to - from) * static_cast<std::size_t>(p) / static_cast<std::size_t>(std::max(probes - 1, 1));
    const std::array<std::size_t, 6> node{k - 3, k - 2, k - 1, k + 1, k + 2, k + 3};
    std::array<double, 6> weight{};
    for (std::size_t a = 0; a < 6; ++a) {
      weight[a] = wavenumber[node[a]] / wavenumber[k];
      for (std::size_t b = 0; b < 6; ++b)
        if (b != a)
          weight[a] *= std::log(wavenumber[k] / wavenumber[node[b]]) /
                       std::log(wavenumber[node[a]] / wavenumber[node[b]]);
    }
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < size; ++j) {
        double g = 0;
        for (std::size_t a = 0; a < 6; ++a)
          g += weight[a] * at(node[a], i * size + j);
        const double self = std::sqrt(at(k, i * size + i) * at(k, j * size + j));
        error = std::max(error, std::abs(g - at(k, i * size + j)) / self);
      }
  }
  return 0.0977 * error;
}

} // namespace bem_contact::fem
