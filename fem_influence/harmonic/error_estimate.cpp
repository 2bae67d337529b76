#include "fem_influence/harmonic/error_estimate.hpp"

#include "bem_contact/base/error.hpp"
#include "bem_contact/influence/expand.hpp"
#include "fem_influence/shared/settings.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace bem_contact::fem {

namespace {

/// mm. Numbers farther away are not compared. Contact patches are smaller, and what is left beyond is the
/// body's motion as a whole.
constexpr double compared_distance = 16.0;
/// 1. Equal steps along the strip between stations that are compared: with the neighbours of three of them at
/// most 64 stations, so that a companion costs a sixth of the run.
constexpr int compared_steps = 24;
/// 1. The mesh's error is stated larger by this factor. The true error was 0.9 to 1.2 of what the ratio of
/// two meshes says (block, disc, rail, wheel), and 1.8 on meshes that are far too coarse.
constexpr double mesh_error_margin = 1.8;
/// 1. How much larger the error of degree 1 is taken than that of degree 2. The limit would be 2^4, but
/// degree 1 is far from the limit (block, disc, rail, wheel).
constexpr double degree_1_over_2 = 5.0;
/// Leaving out every second wavenumber makes the error larger by `sampling_ratio` at `sampling_ratio_at`
/// samples a decade, growing with the third power and limited to `sampling_ratio_most`; 2^6 in the limit of
/// many samples. Benchmark: at 7 and fewer samples 24 or more where numbers are large, 12 at 16 mm on a disc
/// of radius 10; at 10 samples 31 to 57.
constexpr double usual_sampling_ratio = 10.0;
constexpr double sampling_ratio_at = 7.0;
constexpr double sampling_ratio_most = 30.0;

/// How much less accurate every second one of so many samples a decade is than all of them.
double sampling_ratio(int samples_per_decade) {
  return std::clamp(usual_sampling_ratio * std::pow(samples_per_decade / sampling_ratio_at, 3),
                    usual_sampling_ratio, sampling_ratio_most);
}

} // namespace

std::vector<std::size_t> compared_stations(std::size_t count) {
  std::set<std::size_t> chosen;
  const std::size_t last = count - 1;
  const auto steps = static_cast<std::size_t>(compared_steps);
  for (std::size_t i = 0; i <= steps; ++i)
    chosen.insert(last * i / steps);
  for (const std::size_t source : {std::size_t{0}, last / 2, last})
    for (std::size_t far = 1; far < count; far *= 2)
      for (const std::size_t at : {source + far, source - far})
        if (at <= last) // also where source - far wrapped round
          chosen.insert(at);
  return {chosen.begin(), chosen.end()};
}

namespace {

InfluenceFunction part_of(const InfluenceFunction& f, std::span<const std::size_t> stations,
                          std::span<const std::size_t> samples) {
  InfluenceFunction part = without_numbers(f);
  std::vector<std::size_t> column;
  for (const std::size_t J : stations) {
    part.stations.push_back(f.stations[J]);
    for (std::size_t j = 0; j < 3; ++j)
      column.push_back(3 * J + j);
  }
  const std::size_t n = 3 * f.station_count();
  for (const std::size_t a : column)
    for (const std::size_t b : column)
      if (b <= a)
        for (const std::size_t k : samples)
          part.kernel.push_back(f.kernel[f.kernel_index(k, a, b)]);
  for (const std::size_t k : samples) {
    part.wavenumber.push_back(f.wavenumber[k]);
    for (std::size_t m = 0; m < 6; ++m)
      for (const std::size_t b : column)
        part.remote.push_back(f.remote[(k * 6 + m) * n + b]);
    const auto self = f.remote_self.begin() + static_cast<std::ptrdiff_t>(36 * k);
    part.remote_self.insert(part.remote_self.end(), self, self + 36);
  }
  return part;
}

InfluenceNumbers numbers_of(const InfluenceFunction& f, double dx, int offsets) {
  const ExpandOptions removed{.dx = dx, .offsets = offsets};
  try {
    return expand(f, removed);
  } catch (const InputError&) { // no motion of a remote section that could be removed
    ExpandOptions included = removed;
    included.structural = StructuralCompliance::included;
    return expand(f, included);
  }
}

} // namespace

double error_ratio(int degree, int borders) {
  const double of_degree = degree == 2 ? degree_1_over_2 : std::pow(degree / (degree - 1.0), 4);
  return of_degree * (borders > 0 ? 4 : 1) - 1;
}

std::vector<std::size_t> companion_samples(std::size_t count) {
  std::vector<std::size_t> samples;
  for (std::size_t k = 0; k < count; ++k)
    if (k <= static_cast<std::size_t>(settings::exact_harmonics) || (count - 1 - k) % 2 == 0)
      samples.push_back(k);
  return samples;
}

ErrorEstimate estimate_error(const InfluenceFunction& function, const InfluenceFunction& companion,
                             double shortest_dx, double ratio, int samples_per_decade) {
  const auto stations = compared_stations(function.station_count());
  const auto half = companion_samples(function.wavenumber_count());
  const int offsets = 1 + static_cast<int>(std::min(compared_distance, 0.5 * function.half_period) /
                                           shortest_dx * (1 + 1e-9));
  std::vector<std::size_t> all(function.wavenumber_count());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto fine = numbers_of(part_of(function, stations, all), shortest_dx, offsets);
  const auto fewer = numbers_of(part_of(function, stations, half), shortest_dx, offsets);
  const auto coarse = numbers_of(companion, shortest_dx, offsets);

  const double half_ratio = sampling_ratio(samples_per_decade);
  ErrorEstimate estimate;
  const int rows = static_cast<int>(stations.size());
  for (int m = 0; m < offsets; ++m)
    for (int I = 0; I < rows; ++I)
      for (int J = 0; J < rows; ++J) {
        const double along = function.stations[stations[static_cast<std::size_t>(I)]].s -
                             function.stations[stations[static_cast<std::size_t>(J)]].s;
        if (std::hypot(along, m * shortest_dx) > compared_distance)
          continue;
        double local = 0, mesh = 0, samples = 0, total = 0;
        for (int i = 0; i < 3; ++i)
          local = std::max(local, std::abs(fine.at(m, I, i, J, i)));
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            // At the load itself each component has a self number of its own.
            const double scale = m == 0 && I == J
                                     ? std::sqrt(std::abs(fine.at(0, I, i, I, i) * fine.at(0, I, j, I, j)))
                                     : local;
            const double a = std::abs(coarse.at(m, I, i, J, j) - fewer.at(m, I, i, J, j)) / ratio / scale;
            const double b = std::abs(fewer.at(m, I, i, J, j) - fine.at(m, I, i, J, j)) / half_ratio / scale;
            mesh = std::max(mesh, mesh_error_margin * a);
            samples = std::max(samples, b);
            total = std::max(total, mesh_error_margin * a + b);
          }
        estimate.mesh = std::max(estimate.mesh, mesh);
        estimate.samples = std::max(estimate.samples, samples);
        estimate.total = std::max(estimate.total, total);
      }
  return estimate;
}

} // namespace bem_contact::fem
