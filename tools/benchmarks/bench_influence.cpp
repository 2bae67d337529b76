// What it costs to turn influence files into the numbers of a patch:
//   ninja -C build bench_influence && build/bin/bench_influence [RAIL.h5 WHEEL.h5]
// Without files the rail and the wheel of data/influence are used, and made-up kernels of more stations.
#include "bem_contact/halfspace/combine.hpp"
#include "bem_contact/halfspace/flat_strip.hpp"
#include "bem_contact/halfspace/resample.hpp"
#include "bem_contact/influence/expand.hpp"
#include "bem_contact/influence/influence_file.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace {

using namespace bem_contact;

constexpr int offsets = 60, rows = 40;
std::string rail_file = "data/influence/small_rail.h5", wheel_file = "data/influence/small_wheel.h5";

/// Of the right size, symmetric and positive; the numbers mean nothing.
InfluenceFunction made_up(int stations) {
  InfluenceFunction f;
  f.body = "made up";
  f.material = {};
  f.half_period = 600;
  f.station_width = 0.2;
  for (int i = 0; i < stations; ++i)
    f.stations.push_back({0.2 * i, {0.2 * i, 0}, 0});
  for (int k = 0; k < 32; ++k)
    f.wavenumber.push_back(k <= 8 ? k * M_PI / 600 : 8 * M_PI / 600 * std::pow(1200.0, (k - 8) / 23.0));
  const std::size_t n = 3 * f.stations.size();
  f.kernel.resize(32 * f.kernel_size());
  f.remote.resize(32 * 6 * n);
  f.remote_self.assign(32 * 36, 0.0);
  for (std::size_t k = 0; k < 32; ++k) {
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b <= a; ++b)
        f.kernel[f.kernel_index(k, a, b)] = 1e-6 / (1 + f.wavenumber[k] + std::abs(double(a) - double(b)));
    for (std::size_t d = 0; d < 6; ++d)
      f.remote_self[36 * k + 7 * d] = 1e-6;
  }
  return f;
}

/// The patch of the bars: 60 offsets x 40 rows in the middle of the strip. `stretch` takes the rows off the
/// stations and off equal spacing, as a wheel's rows are.
std::vector<double> middle_rows(const InfluenceFunction& f, double stretch) {
  const auto first = (f.station_count() - rows) / 2;
  std::vector<double> s;
  for (int i = 0; i < rows; ++i)
    s.push_back(f.stations[first].s + f.station_width * (i + stretch * std::sin(0.3 * i)));
  return s;
}

ExpandOptions patch_options(const InfluenceFunction& f) {
  ExpandOptions options;
  options.dx = std::max(0.2, 10.001 / f.wavenumber.back());
  options.offsets = offsets;
  return options;
}

void read_file(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(read_influence_file(wheel_file));
}
BENCHMARK(read_file)->Unit(benchmark::kMillisecond);

void expand_strip(benchmark::State& state) {
  const InfluenceFunction f = made_up(static_cast<int>(state.range(0)));
  const ExpandOptions options = patch_options(f);
  for (auto _ : state)
    benchmark::DoNotOptimize(expand(f, options));
}
BENCHMARK(expand_strip)->Arg(40)->Arg(100)->Unit(benchmark::kMillisecond);

void expand_40_rows_of(benchmark::State& state) {
  const InfluenceFunction f = made_up(static_cast<int>(state.range(0)));
  ExpandOptions options = patch_options(f);
  options.first_station = static_cast<int>(state.range(0)) / 2 - 20;
  options.stations = rows;
  for (auto _ : state)
    benchmark::DoNotOptimize(expand(f, options));
}
BENCHMARK(expand_40_rows_of)->Arg(100)->Arg(400)->Unit(benchmark::kMillisecond);

void halfspace_numbers(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(halfspace::influence_numbers({}, 0.2, 0.2, offsets, rows));
}
BENCHMARK(halfspace_numbers)->Unit(benchmark::kMillisecond);

void resample_on_stations(benchmark::State& state) {
  const InfluenceFunction f = read_influence_file(rail_file);
  const auto s = middle_rows(f, 0);
  for (auto _ : state)
    benchmark::DoNotOptimize(halfspace::resample(f, patch_options(f), s, f.station_width));
}
BENCHMARK(resample_on_stations)->Unit(benchmark::kMillisecond);

void resample_between_stations(benchmark::State& state) {
  const InfluenceFunction f = read_influence_file(wheel_file);
  const auto s = middle_rows(f, 1e-3);
  for (auto _ : state)
    benchmark::DoNotOptimize(halfspace::resample(f, patch_options(f), s, f.station_width));
}
BENCHMARK(resample_between_stations)->Unit(benchmark::kMillisecond);

void pair_of_a_patch(benchmark::State& state) {
  const InfluenceFunction rail = read_influence_file(rail_file), wheel = read_influence_file(wheel_file);
  const auto rail_s = middle_rows(rail, 0), wheel_s = middle_rows(wheel, 1e-3);
  const ExpandOptions options = patch_options(rail);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        halfspace::combine(halfspace::resample(rail, options, rail_s, rail.station_width),
                           halfspace::resample(wheel, options, wheel_s, rail.station_width)));
}
BENCHMARK(pair_of_a_patch)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc == 3) {
    rail_file = argv[1];
    wheel_file = argv[2];
  }
  benchmark::RunSpecifiedBenchmarks();
}
